#pragma once
// What can be concealed in a record: `--hide EFFECT[:parameter=value,…]`.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "pem/case_parameters.hpp"
#include "simulate/only_here_parameters.hpp"

namespace railpem::simulate {

/// A parameter of an effect as `--hide` takes it. Text parameters (channel, stage, key of the case) have no range and
/// no default.
struct HiddenParameter {
    std::string name, unit;
    double low = 0.0, high = 0.0;
    double standard = 0.0;  ///< taken when the parameter is not given
    bool is_text = false;
    std::string says;
};

/// Values of one instance as they act, defaults filled in.
struct HiddenValues {
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;
    std::vector<std::string> given;  ///< names that stood in the text
    bool has(const std::string& name) const;
};

/// Multiplies the case's value of a dotted key by a factor; given by whoever owns the schema (the effect that
/// is a wrong number).
using ScaleParameter = std::function<void(pem::CaseParameters&, const std::string& key, double factor)>;

struct HiddenTarget {
    pem::CaseParameters& parameters;
    OnlyHereParameters& only_here;
    const ScaleParameter& scale;
};

/// What an effect does to the world that is marched.
using HideInWorld = std::function<void(const HiddenValues&, HiddenTarget)>;

/// An effect of the catalogue as it can be hidden.
struct HiddenEffect {
    std::string id;
    std::string says;
    std::string place;       ///< element of the structure
    bool only_here = false;  ///< the diagnosis does not know it: exists in the simulator alone
    std::vector<HiddenParameter> parameters;
    HideInWorld apply;
};

/// The effects that a diagnosis knows, then those that exist only here.
const std::vector<HiddenEffect>& hidden_effects();

/// What the files of simulate/effects do, by identifier: written by the build.
std::map<std::string, HideInWorld> effects_in_world();

/// An effect with its values, as asked for.
struct Hidden {
    std::string id;
    HiddenValues values;
    bool forced = false;  ///< a value lies outside its range
};

/// Reads `EFFECT[:parameter=value,…]`. Throws parameters::ParameterError ("--hide") for an unknown effect or parameter,
/// a value that is no number, and a value outside its range unless `force`.
Hidden parse_hidden(const std::string& text, bool force = false);

/// Puts the effect into the case, or into what exists only here. The case is to be checked afterwards.
void apply_hidden(const Hidden& hidden, pem::CaseParameters& parameters, OnlyHereParameters& only_here,
                  const ScaleParameter& scale = {});

/// Text for `simulate --list`: the effects that exist only here with parameters and ranges, Markdown.
std::string describe_hidden();

/// The effect, its place, and its parameters as a JSON object, for the truth file.
std::string hidden_json(const Hidden& hidden);

}  // namespace railpem::simulate

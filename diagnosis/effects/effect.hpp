#pragma once
// An effect: physics that a believed model may have left out, as something that can be named, switched on and fitted.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "parameters/field.hpp"
#include "pem/case_parameters.hpp"

namespace railpem::diagnosis {

/// Elements of the structure in which an effect can sit.
enum class Element { secondary, primary, body, bogie, wheel, contact, rail, pad, support, irregularity, sensor };

/// The element as the diagnosis writes it.
std::string element_name(Element element);

/// How believable strengths are spread over the range before any data are seen.
enum class Spread { uniform, logarithmic };

/// A continuous parameter of an effect.
struct EffectParameter {
    std::string name;  ///< as in the catalogue, with its unit
    std::string unit;
    double low = 0.0;
    double high = 1.0;
    double typical = 0.5;  ///< a moderate strength, for figures and starting points
    Spread spread = Spread::uniform;
    bool strength = false;  ///< the effect vanishes as this goes to `nothing`
    double nothing = 0.0;
    std::string says;
};

/// A discrete parameter: which wheel, order, channel, stage, key of the case. Written in files as text or whole number.
struct EffectChoice {
    std::string name;
    std::vector<std::string> options;  ///< empty: any key of the case (parameter-error)
    bool whole_number = false;
    bool required = true;
    std::string says;
};

/// One instance of an effect with its values; names as in the catalogue.
struct EffectInstance {
    std::string effect;
    std::map<std::string, double> values;
    std::map<std::string, std::string> choices;
};

/// Access to the numeric keys of a case by dotted path; given by whoever owns the schema.
struct ParameterAccess {
    std::function<double(const pem::CaseParameters&, const std::string& key)> get;
    std::function<void(pem::CaseParameters&, const std::string& key, double value)> set;
    std::vector<std::string> keys;
};

/// A band of frequencies in which an effect shows, Hz.
struct Band {
    double low_hz;
    double high_hz;
};

struct Effect {
    std::string id;        ///< as in the catalogue
    std::string says;      ///< what was left out, one sentence in plain words
    std::string equation;
    std::string source;    ///< literature
    std::vector<EffectParameter> parameters;
    std::vector<EffectChoice> choices;
    std::vector<Element> elements;  ///< where it sits; several when a choice decides
    std::vector<Band> bands;
    std::string mimics;    ///< what looks like it, and what would tell them apart
    /// Turns a believed case into one with the effect. Values must lie in their ranges unless the caller forces them;
    /// missing values take the typical ones. Never depends on the order in which effects are applied, except that
    /// the effects of the support need the two-layer support first.
    std::function<void(pem::CaseParameters&, const EffectInstance&, const ParameterAccess&)> apply;
};

/// The library, in the order of the catalogue.
const std::vector<Effect>& effects();

/// The effect of that identifier, or null.
const Effect* find_effect(const std::string& id);

/// Value of a parameter of an instance: the stated one or the typical one.
double value_of(const Effect& effect, const EffectInstance& instance, const std::string& name);

/// The element in which this instance sits (suspension friction: that of its stage; parameter-error: that of its key).
Element element_of(const Effect& effect, const EffectInstance& instance);

/// Checks names, ranges and choices. Throws parameters::ParameterError with key "effect.<name>". `force` allows values out of range.
void check(const EffectInstance& instance, const ParameterAccess& access, bool force = false);

/// Applies an instance after checking it.
void apply(const EffectInstance& instance, const ParameterAccess& access, pem::CaseParameters& parameters);

/// The reference page of the library, Markdown.
std::string describe_effects();

}  // namespace railpem::diagnosis

#pragma once
// An effect: physics that a believed model may have left out, as something that can be named, switched on and fitted.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/effects/element.hpp"
#include "pem/case_parameters.hpp"

namespace railpem::diagnosis {

/// How believable values are spread over the range before any data are seen.
enum class Spread { uniform, logarithmic };

/// A continuous parameter of an effect.
struct EffectParameter {
    std::string name;  ///< as in the catalogue, with its unit
    std::string unit;
    double low = 0.0;  ///< of the physical range, ends included
    double high = 1.0;
    double typical = 0.5;  ///< a moderate strength, for figures and starting points
    Spread spread = Spread::uniform;
    bool strength = false;  ///< the effect vanishes as all parameters so marked go to `nothing`
    double nothing = 0.0;   ///< may be infinite, or lie outside of the range
    /// the effect is a source of its own whose power grows with (value − nothing)²: no derivative at nothing shows it
    bool amplitude = false;
    bool law = false;  ///< bends the law of an effect that is there: sought from its typical value alone
    /// a distance with lines at all multiples of v/distance: its divisors and multiples have many of them too
    bool comb = false;
    /// relative standard deviation by which fitted values miss those of marched records beyond what the data leave
    /// open: what the law itself gets wrong
    double inexact = 0.0;
    /// distance from `nothing` below which nobody would speak of the effect: models are off by as much
    double least = 0.0;
    std::string says;
};

/// A discrete parameter: which wheel, order, channel, stage, key of the case. Written in files as text or whole number.
struct EffectChoice {
    std::string name;
    std::vector<std::string> options;  ///< empty: any number of the case by its dotted key (parameter-error)
    bool whole_number = false;         ///< options are whole numbers, without gaps
    bool required = true;
    std::string replaces;  ///< parameter that means nothing, and must not be given, beside this choice
    std::string says;
};

/// One instance of an effect with its values; names as in the catalogue.
struct EffectInstance {
    std::string effect;
    std::map<std::string, double> values;
    std::map<std::string, std::string> choices;
};

/// Access to the numbers of a case by dotted path; given by whoever owns the schema. `set` throws
/// parameters::ParameterError when the value is none that the number may have.
struct ParameterAccess {
    std::function<double(const pem::CaseParameters&, const std::string& key)> get;
    std::function<void(pem::CaseParameters&, const std::string& key, double value)> set;
    std::vector<std::string> keys;
};

/// A band of frequencies in which an effect shows, Hz, for a car of some 10 t axle load at 80 km/h.
struct Band {
    double low_hz;
    double high_hz;
};

/// Why an effect cannot be added to a case, and what case it would need.
struct Obstacle {
    std::string problem;
    std::string allowed;
};

struct Effect {
    std::string id;    ///< as in the catalogue
    std::string says;  ///< what was left out, one sentence in plain words
    std::string equation;
    std::string source;  ///< literature
    std::vector<EffectParameter> parameters;
    std::vector<EffectChoice> choices;
    std::vector<Element> elements;  ///< where it sits; several when a choice decides
    std::vector<Band> bands;
    std::string mimics;         ///< what looks like it, and what would tell them apart
    std::string not_told = {};  ///< what of its law no recording of the usual kind tells: said wherever it is named
    /// in its range it is never slight: screening looks at typical values instead of near nothing
    bool abrupt = false;
    int most_instances = 1;  ///< of one variant in a set
    /// its law is an approximation (linearised about the level of vibration, or one that nothing in time obeys): part
    /// of it stays unexplained
    bool approximate = false;
    /// tolerances by which numbers of the case may end off beside it, furthest_number(): what its law leaves is put
    /// down to them; 0: as beside any other
    double bends_numbers = 0.0;
    /// it takes the place of a law of the case: no derivative at vanishing strength speaks for it
    bool replaces = false;
    bool excites = false;  ///< it adds to what excites; how anything responds to it stays as it is, wherever it sits
    bool lines_alone = false;  ///< what it adds are lines, and nothing broadband changes
    /// retuning moves the same within its belief: where that is given up for a name the recordings themselves need gain
    /// nothing
    bool retuned = false;
    /// what it does differs with the wheel load of a recording: a free correction, the same for all of them, need not
    /// show it
    bool follows_load = false;
    /// What in the case forbids the effect (it is there already, or something else overrides it); null: nothing can.
    std::function<std::optional<Obstacle>(const pem::CaseParameters&)> obstacle;
    /// Turns a believed case into one with the effect by setting data. The instance states every parameter. Adds to
    /// what the case has of the same kind, so that several effects do not depend on the order in which they are
    /// applied.
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

/// Checks identifier, names, ranges and choices. `force` allows values out of range.
/// Throws parameters::ParameterError with key "effect.<name>".
void check(const EffectInstance& instance, const ParameterAccess& access, bool force = false);

/// Applies an instance after checking it; parameters that it does not state are typical. Effects of the support need
/// the two-layer support first. Throws parameters::ParameterError like check(), and with key "effect.id" when the case
/// forbids the effect.
void apply(const EffectInstance& instance, const ParameterAccess& access, pem::CaseParameters& parameters,
           bool force = false);

/// The order in which several instances are applied, as indices, whatever the order in which they are listed: first
/// believed values are put right (parameter-error), then the effects follow in the order of the catalogue.
std::vector<std::size_t> application_order(const std::vector<EffectInstance>& instances);

/// Applies several in their application_order().
void apply(const std::vector<EffectInstance>& instances, const ParameterAccess& access, pem::CaseParameters& parameters,
           bool force = false);

/// The reference page of the library, Markdown.
std::string describe_effects();

}  // namespace railpem::diagnosis

#pragma once
// An effect: physics that a believed model may have left out, as something that can be named, switched on and fitted.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/effects/element.hpp"
#include "effects/effect_description.hpp"
#include "pem/case_parameters.hpp"

namespace railpem::diagnosis {

using effects::Band;
using effects::EffectChoice;
using effects::EffectParameter;
using effects::Spread;

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

/// Why an effect cannot be added to a case, and what case it would need.
struct Obstacle {
    std::string problem;
    std::string allowed;
};

/// What an effect does to the model, and what a diagnosis has to know of that. What it is called and which numbers it
/// has stands in effects/catalogue.
struct EffectInModel {
    /// in its range it is never slight: screening looks at typical values instead of near nothing
    bool abrupt = false;
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
    /// the pads are others under another wheel load: a free correction, the same for all recordings, need not show it,
    /// and whatever moves the load moves the track
    bool follows_load = false;
    bool follows_level = false;  ///< it is linearised about the level of vibration: what excites changes its law
    bool needs_train = false;    ///< a track without the load of wheels does not show it
    /// nothing says where in their ranges its numbers lie beside its strength: each is looked for from both ends and
    /// the middle
    bool looked_for_over_ranges = false;
    bool needs_time_series = false;  ///< spectra without cross-spectra do not show it
    bool needs_lines = false;        ///< it shows by the height of spectral lines, which quoted points do not have
    /// What in the case forbids the effect (it is there already, or something else overrides it); null: nothing can.
    std::function<std::optional<Obstacle>(const pem::CaseParameters&)> obstacle = {};
    /// Turns a believed case into one with the effect by setting data. The instance states every parameter. Adds to
    /// what the case has of the same kind, so that several effects do not depend on the order in which they are
    /// applied.
    std::function<void(pem::CaseParameters&, const EffectInstance&, const ParameterAccess&)> apply;
};

/// An effect of the library: its nouns and its physics.
struct Effect : effects::EffectDescription, EffectInModel {};

/// What the files of diagnosis/effects do to the model, by identifier: written by the build.
std::map<std::string, EffectInModel> effects_in_model();

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

/// A number of the case that is wrong by a factor.
EffectInstance wrong_number(const std::string& key, double factor);

/// A channel that reads too high by a factor; negative: inverted.
EffectInstance wrong_gain(const std::string& channel, double gain);

/// The instance says that a number of the case is wrong.
bool is_wrong_number(const EffectInstance& instance);

}  // namespace railpem::diagnosis

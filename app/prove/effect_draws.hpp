#pragma once
// How strong effects are when a trial draws them.

#include <string>
#include <vector>

namespace railpem::app {

/// How a value is spread over its range: uniformly, uniformly in its logarithm, or over the whole numbers of it.
enum class DrawSpacing { uniform, logarithmic, whole };

/// What becomes of a drawn value with even odds.
enum class DrawMirror { none, sign, inverse };

/// A parameter of an effect and the range from which trials take it: value = offset ± x · other^power.
struct DrawnParameter {
    std::string name;  ///< as in `simulate --list`
    double low = 0.0, high = 0.0;
    DrawSpacing spacing = DrawSpacing::uniform;
    DrawMirror mirror = DrawMirror::none;
    double offset = 0.0;    ///< added at the end: a gain is 1 ± x
    std::string scaled_by;  ///< parameter drawn before this one, whose power scales this one; empty: none
    double power = 0.0;
};

/// One way to draw an effect. An effect may have several, which are then equally likely.
struct EffectDraw {
    std::string id;
    std::vector<DrawnParameter> parameters;  ///< those not among them keep the simulator's default
    std::string strength;                    ///< parameter by which the effect fades; empty: it is there or not
    bool weak_when_large = false;
    double nothing = 0.0;  ///< value at which it has faded (0 where it fades towards infinity)
};

/// Physics of the catalogue, from barely detectable to obvious for the paper's car between 12 and 40 m/s.
/// `sleeper-flexibility` is drawn only where the case has sleepers.
const std::vector<EffectDraw>& physics_draws();

/// Sensor faults of the catalogue.
const std::vector<EffectDraw>& sensor_draws();

/// A believed value that is wrong beyond its tolerance; the trial adds the key.
const EffectDraw& parameter_error_draw();

/// Effects that the simulator has and the catalogue has not.
const std::vector<EffectDraw>& outside_draws();

/// The first draw of that effect in any of the lists, or null.
const EffectDraw* find_draw(const std::string& id);

}  // namespace railpem::app

#pragma once
// How strong an effect is where the proof hides it.

#include <string>
#include <vector>

namespace railpem::effects {

/// How a value is spread over its range: uniformly, uniformly in its logarithm, or over the whole numbers of it.
enum class DrawSpacing { uniform, logarithmic, whole };

/// What becomes of a drawn value with even odds.
enum class DrawMirror { none, sign, inverse };

/// A parameter of an effect and the range from which trials take it: value = offset ± x · other^power.
struct DrawnParameter {
    std::string name;  ///< as in `simulate --list`
    double low = 0.0;
    double high = 0.0;
    DrawSpacing spacing = DrawSpacing::uniform;
    DrawMirror mirror = DrawMirror::none;
    double offset = 0.0;    ///< added at the end: a gain is 1 ± x
    std::string scaled_by;  ///< parameter drawn before this one, whose power scales this one; empty: none
    double power = 0.0;
    double upside_down = 0.0;  ///< share of draws in which the value is −1 instead: a sensor mounted the wrong way up
};

/// One way to draw an effect, from barely detectable to obvious for the paper's car between 12 and 40 m/s. An effect
/// may have several, which are then equally likely.
struct EffectDraw {
    std::vector<DrawnParameter> parameters;  ///< those not among them keep the simulator's default
    std::string strength;        ///< parameter by which the effect fades; empty: it is there or not, or several do
    std::string wavelength;      ///< length parameter of a line that has to lie where recordings look; empty: none
    std::string waves_per_turn;  ///< the same of a wheel: number of waves around it
};

}  // namespace railpem::effects

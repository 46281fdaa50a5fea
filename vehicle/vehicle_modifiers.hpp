#pragma once
// What a diagnosis lets a car differ by from its parameters: complex factors over frequency, 1 when empty. Modes and
// hung masses keep their own.

#include <array>

#include "lanes/factor_curve.hpp"

namespace railpem::vehicle {

/// Dynamic masses attached to a rigid body at its centre and, a radius of gyration before and behind it, at its front
/// and rear, in multiples of its mass: heave, pitch and what couples them each on its own. Nothing when empty.
struct Attachments {
    lanes::FactorCurve centre, front, rear;
};

struct VehicleModifiers {
    lanes::FactorCurve primary, secondary;  ///< on the whole dynamic stiffness of every element, friction included
    lanes::FactorCurve body;                ///< on the body's mass (with payload) and pitch inertia
    lanes::FactorCurve bogies;              ///< on mass and pitch inertia of both bogies
    lanes::FactorCurve wheelsets;           ///< on the mass of every wheelset
    std::array<lanes::FactorCurve, 2> one_bogie;     ///< and on those of one bogie only
    std::array<lanes::FactorCurve, 4> one_wheelset;  ///< and on the mass of one wheelset only
    Attachments body_attachments;                    ///< to the body, payload included
    Attachments between_bogies;  ///< to the difference of both bogies' motions, seen from the middle of the car
};

}  // namespace railpem::vehicle

#pragma once
// Natural frequencies and damping of the car on springs.

#include <string>
#include <vector>

#include "vehicle/half_vehicle.hpp"

namespace railpem::vehicle {

/// What moves most in a natural motion, by kinetic energy.
enum class Motion { body_bounce, body_pitch, bogie_bounce, bogie_pitch, wheels, bending_or_hung };

struct NaturalFrequency {
    double frequency_hz = 0.0;   ///< |λ|/2π of the eigenvalue λ
    double damping_ratio = 0.0;  ///< −Re λ/|λ|; below 1e-9 of rounding 0
    Motion motion = Motion::body_bounce;
};

/// In words: "body bounce".
std::string motion_name(Motion motion);

/// Oscillating natural motions of the half vehicle whose four wheels stand on springs `ground_n_per_m` > 0 each (track
/// and contact in series), by increasing frequency; those that are damped beyond critical do not oscillate and are left
/// out. Dampers with series springs are Maxwell elements; friction counts by its equivalent damping `car.friction`;
/// corrections of a diagnosis (`car.modifiers`) do not count. Eigenvalues of the first-order form, exact to rounding.
std::vector<NaturalFrequency> natural_frequencies(const HalfVehicle& car, double ground_n_per_m);

}  // namespace railpem::vehicle

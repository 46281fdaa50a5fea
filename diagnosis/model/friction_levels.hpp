#pragma once
// The velocities at which recordings know dry friction.

#include <string>
#include <vector>

#include "diagnosis/model/trial.hpp"

namespace railpem::diagnosis {

/// Rms velocities across the elements of a stage that has friction.
struct FrictionLevel {
    Element stage = Element::primary;
    double slowest_m_per_s = 0.0, fastest_m_per_s = 0.0;  ///< over elements and recordings
};

/// Of every stage in which `trial` has friction, over the time series of a vehicle, as statistical linearisation finds
/// them (pem::linearise()); none without friction or such a recording. Friction that falls with the velocity from r·F
/// to F over v_s (Stribeck) damps at rms velocity σ like the constant one of F·[1 + (r − 1)/(1 + 2σ²/v_s²)], the mean
/// of F·[1 + (r − 1)e^(−(v/v_s)²)]·|v| over that of |v|, v Gaussian: a force is known at these velocities.
std::vector<FrictionLevel> friction_levels(const Trial& trial, const BelievedCase& believed,
                                           const std::vector<Observation>& observations);

/// The same in words.
std::vector<std::string> said_of_friction(const std::vector<FrictionLevel>& levels);

}  // namespace railpem::diagnosis

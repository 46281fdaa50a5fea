#pragma once
// Units that are made of a vibration's unit: of power spectral densities and of frequency responses to a force.

#include <optional>
#include <string>
#include <string_view>

namespace railpem::recordings {

/// "g²/Hz", "(m/s^2)^2/Hz", "m^2/s^4/Hz", "m2/s3" → the unit whose square per Hz it is: g, m/s^2. Empty: no density of
/// a unit that is known.
std::optional<std::string> unit_of_density(std::string_view unit);

/// A vibration's unit per unit of force.
struct PerForce {
    std::string unit;        ///< of the vibration, as written
    double newtons = 1.0;    ///< in one unit of the force
    bool has_force = false;  ///< the unit names a force
};

/// "g/N", "(m/s^2)/N", "mm/kN", "m/(N*s^2)", "m/N/s^2" → g, m/s^2, mm; a unit without a force comes back as it is.
PerForce unit_per_force(std::string_view unit);

/// Newtons in a unit of force: N, kN, MN, mN, lbf; empty for any other.
std::optional<double> newtons_of(std::string_view unit);

}  // namespace railpem::recordings

#include "track/elements/rail_damper.hpp"

#include <cmath>

namespace railpem::track {

std::complex<double> damper_mass_kg_per_m(const std::vector<RailDamper>& dampers, double frequency_hz) {
    std::complex<double> mass = 0.0;
    for (const RailDamper& damper : dampers) {
        const double ratio = frequency_hz / damper.frequency_hz;
        const std::complex<double> spring(1.0, damper.loss_factor * std::pow(ratio, damper.loss_exponent));
        mass += damper.mass_kg_per_m * spring / (spring - ratio * ratio);
    }
    return mass;
}

}  // namespace railpem::track

#include "diagnosis/observations/force_reference.hpp"

#include <cmath>
#include <numbers>

#include "pem/response_names.hpp"

namespace railpem::diagnosis {

std::vector<double> force_reference(const Observation& observation, const std::vector<double>& nodes) {
    const double mass_kg = kObservationSettings.reference_mass_kg, side = kObservationSettings.reference_side;
    const std::size_t size = observation.channels.size();
    const auto is_bogie = [&](std::size_t c) {
        return pem::response_names()[observation.channels[c].response].where.starts_with("bogie");
    };
    bool any_bogie = false;
    for (std::size_t c = 0; c < size; ++c) any_bogie = any_bogie || is_bogie(c);
    std::vector<double> reference;
    for (const double node : nodes) {
        double sum = 0.0, count = 0.0;
        for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
            const double f = observation.frequency(bin);
            if (f < node / side || f > node * side) continue;
            for (std::size_t c = 0; c < size; ++c) {
                if (any_bogie && !is_bogie(c)) continue;
                sum += observation.fitted.values[bin * size * size + c * (size + 1)].real() *
                       std::pow(2.0 * std::numbers::pi * f, 2 * observation.channels[c].integrations);
                count += 1.0;
            }
        }
        reference.push_back(mass_kg * mass_kg * (count > 0.0 ? sum / count : 1.0));
    }
    return reference;
}

}  // namespace railpem::diagnosis

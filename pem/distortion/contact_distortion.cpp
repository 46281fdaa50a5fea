#include "pem/distortion/contact_distortion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pem/contact.hpp"
#include "pem/coupling/coupled_model.hpp"
#include "pem/coupling/excite.hpp"
#include "pem/coupling/wheel_transfers.hpp"
#include "pem/gaussian_mean.hpp"
#include "pem/response_names.hpp"

namespace railpem::pem {

namespace {

double shortest_wave(const spectra::IrregularityParameters& irregularity) {
    double shortest = 1e300;
    for (const spectra::IrregularityBand& band : irregularity.bands)
        shortest = std::min(shortest, band.shortest_wavelength_m);
    return shortest;
}

double static_approach(const CaseParameters& parameters) {
    return contact_constant(parameters.contact, parameters.vehicle.wheel_radius_m) *
           std::pow(wheel_load_n(parameters), 2.0 / 3.0);
}

/// Contact forces per unit irregularity at kSquareStep_hz, 2·kSquareStep_hz, … to the shortest wave.
SquareTransfers force_transfers(const CaseParameters& parameters, double speed) {
    const CoupledModel model = coupled_model(parameters, speed);
    const auto lines = static_cast<std::size_t>(speed / shortest_wave(parameters.irregularity) / kSquareStep_hz);
    std::vector<RailGroup> rails = rail_groups(model, kSquareStep_hz, kSquareStep_hz, lines, kSquareRailEvery, 1);
    std::vector<std::size_t> contacts;
    for (const char* wheel : {"contact_1", "contact_2", "contact_3", "contact_4"})
        contacts.push_back(response_index(wheel));
    const WheelTransfers force = wheel_transfers(model, kSquareStep_hz, kSquareStep_hz, lines, contacts, 1, &rails);
    SquareTransfers transfers(lines);
    for (std::size_t line = 0; line < lines; ++line) std::copy_n(force.at(line), 16, transfers[line].begin());
    return transfers;
}

}  // namespace

double contact_force_variation(const CaseParameters& parameters, double speed) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const SquareTransfers force = force_transfers(parameters, speed);
    std::array<double, 4> power{};
    for (const DelayedSpectrum& source : excitation(parameters, wheels, speed).broadband)
        for (std::size_t line = 0; line < force.size(); ++line) {
            const std::array<std::complex<double>, 4> e =
                met(source, wheels, speed, static_cast<double>(line + 1) * kSquareStep_hz);
            for (std::size_t wheel = 0; wheel < 4; ++wheel) {
                std::complex<double> own = 0.0;
                for (std::size_t j = 0; j < 4; ++j) own += force[line][wheel * 4 + j] * e[j];
                power[wheel] += std::norm(own) * kSquareStep_hz;
            }
        }
    return std::sqrt(*std::max_element(power.begin(), power.end())) / wheel_load_n(parameters);
}

ContactDistortion contact_distortion(const CaseParameters& parameters, double speed,
                                     const std::function<double(double)>& force_power_ratio) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const double load = wheel_load_n(parameters);
    SquareTransfers transfers = force_transfers(parameters, speed);
    for (std::size_t line = 0; line < transfers.size(); ++line)
        for (std::complex<double>& own : transfers[line])
            own *= std::sqrt(std::max(0.0, force_power_ratio(static_cast<double>(line + 1) * kSquareStep_hz)));
    const PairCorrelations correlations =
        pair_correlations(transfers, excitation(parameters, wheels, speed).broadband, wheels, speed, kHighestOrder);
    double variance = 0.0;
    for (std::size_t wheel = 0; wheel < 4; ++wheel) variance += 0.25 * correlations.variance(wheel);
    ContactDistortion result{.force_variation = std::sqrt(variance) / load,
                             .static_approach_m = static_approach(parameters),
                             .nonlinearity = parameters.contact.nonlinearity_factor,
                             .power = {}};
    for (int order = 2; order <= kHighestOrder; ++order)
        result.power.push_back(contrasts_of_powers(correlations, order, variance));
    return result;
}

ApproachOrders approach_orders(double nonlinearity, double force_variation) {
    return gaussian_mean([&](double xi) {
        ApproachOrders orders;
        double before = 1.0, own = xi;  // He_n/√n! one after the other, whose squares have the mean 1
        for (long n = 2; n <= kHighestOrder; ++n) {
            const double next =
                (xi * own - std::sqrt(static_cast<double>(n) - 1.0) * before) / std::sqrt(static_cast<double>(n));
            before = std::exchange(own, next);
            orders(n - 2) = own;
        }
        return ApproachOrders(orders * contact_approach(nonlinearity, 1.0 + force_variation * xi));
    });
}

std::vector<DelayedSpectrum> distortion_sources(const ContactDistortion& distortion, const CaseParameters& parameters) {
    std::vector<DelayedSpectrum> sources;
    if (distortion.power.empty()) return sources;
    const double own = parameters.contact.nonlinearity_factor,
                 at_rest = own == distortion.nonlinearity ? distortion.static_approach_m : static_approach(parameters);
    const ApproachOrders orders = at_rest * approach_orders(own > 0.0 ? own : 1.0, distortion.force_variation);
    for (std::size_t contrast = 0; contrast < kContrasts.size(); ++contrast) {
        std::vector<double> power(distortion.power.front()[contrast].size(), 0.0);
        for (std::size_t order = 0; order < distortion.power.size(); ++order) {
            const double share = std::pow(orders(static_cast<long>(order)), 2);
            for (std::size_t k = 0; k < power.size(); ++k) power[k] += share * distortion.power[order][contrast][k];
        }
        sources.push_back(contrast_source("contact_distortion", contrast, std::move(power)));
    }
    return sources;
}

}  // namespace railpem::pem

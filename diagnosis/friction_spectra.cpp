#include "diagnosis/friction_spectra.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "pem/friction_distortion.hpp"
#include "pem/inner_transfers.hpp"
#include "pem/linearise.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;
using Rows = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Matrices on a uniform grid, linear between its lines.
struct LineTable {
    const Complex* values;
    long rows, columns;
    double from_hz, step_hz;
    std::size_t lines;
    Rows at(double frequency) const {
        const double place = std::clamp((frequency - from_hz) / step_hz, 0.0, static_cast<double>(lines) - 1.001), share = place - std::floor(place);
        const Complex* low = values + static_cast<std::size_t>(place) * static_cast<std::size_t>(rows * columns);
        return (1.0 - share) * Eigen::Map<const Rows>(low, rows, columns) + share * Eigen::Map<const Rows>(low + rows * columns, rows, columns);
    }
};

void add_stage(const pem::CaseParameters& parameters, const LinearisedCase& own, vehicle::Law law, double force, const std::vector<ObservedChannel>& channels,
               double bin_hz, ExpectedSpectra& expected) {
    std::vector<std::size_t> responses;
    for (const ObservedChannel& channel : channels) responses.push_back(channel.response);
    const pem::VelocitySpectra velocity = pem::velocity_spectra(parameters, own.sources, own.model, law, own.level_rails);
    const std::vector<Complex> power = pem::friction_distortion(velocity, force);
    const pem::InnerTransfers transfers = pem::inner_transfers(own.model, law, own.from_hz, own.step_hz, own.lines, responses, own.rails);
    const long size = static_cast<long>(channels.size()), elements = static_cast<long>(velocity.elements);
    const LineTable transfer{transfers.values.data(), size, elements, transfers.from_hz, transfers.step_hz, transfers.lines};
    const LineTable psd{power.data(), elements, elements, velocity.from_hz, velocity.step_hz, velocity.lines};
    for (std::size_t b = 0; b < expected.bins(); ++b) {
        const double frequency = static_cast<double>(expected.first_bin + b) * bin_hz;
        Rows t = transfer.at(frequency);
        for (long c = 0; c < size; ++c) t.row(c) *= channel_factor(parameters, channels[static_cast<std::size_t>(c)], frequency);
        expected.matrix(b) += t * psd.at(frequency) * t.adjoint();
    }
}

}  // namespace

bool has_friction(const pem::CaseParameters& parameters) {
    return parameters.vehicle.primary.friction_force_n > 0.0 || parameters.vehicle.secondary.friction_force_n > 0.0;
}

void add_friction(const pem::CaseParameters& parameters, const LinearisedCase& linearised, const std::vector<ObservedChannel>& channels, double bin_hz,
                  ExpectedSpectra& expected) {
    const vehicle::VehicleParameters& car = parameters.vehicle;
    if (car.primary.friction_force_n > 0.0)
        add_stage(parameters, linearised, vehicle::Law::primary, car.primary.friction_force_n, channels, bin_hz, expected);
    if (car.secondary.friction_force_n > 0.0)
        add_stage(parameters, linearised, vehicle::Law::secondary, car.secondary.friction_force_n, channels, bin_hz, expected);
}

}  // namespace railpem::diagnosis

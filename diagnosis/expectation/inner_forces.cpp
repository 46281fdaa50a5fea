#include "diagnosis/expectation/inner_forces.hpp"

#include <algorithm>
#include <cmath>

#include "pem/coupling/inner_transfers.hpp"

namespace railpem::diagnosis {

RowMatrix LineTable::at(double frequency_hz) const {
    const double place = std::clamp((frequency_hz - from_hz) / step_hz, 0.0, static_cast<double>(lines) - 1.001),
                 share = place - std::floor(place);
    const std::complex<double>* low =
        values + static_cast<std::size_t>(place) * static_cast<std::size_t>(rows * columns);
    return (1.0 - share) * Eigen::Map<const RowMatrix>(low, rows, columns) +
           share * Eigen::Map<const RowMatrix>(low + rows * columns, rows, columns);
}

void add_inner_forces(const pem::CaseParameters& parameters, const SolvedLines& solved, vehicle::Law law,
                      const std::function<RowMatrix(double)>& psd, const std::vector<ObservedChannel>& channels,
                      double bin_hz, ExpectedSpectra& expected) {
    std::vector<std::size_t> responses;
    for (const ObservedChannel& channel : channels) responses.push_back(channel.response);
    const pem::InnerTransfers transfers =
        pem::inner_transfers(solved.model, law, solved.from_hz, solved.step_hz, solved.lines, responses, solved.rails);
    const long size = static_cast<long>(channels.size());
    const LineTable transfer{
        transfers.values.data(), size,           static_cast<long>(transfers.elements), transfers.from_hz,
        transfers.step_hz,       transfers.lines};
    for (std::size_t b = 0; b < expected.bins(); ++b) {
        const double frequency = static_cast<double>(expected.first_bin + b) * bin_hz;
        RowMatrix t = transfer.at(frequency);
        for (long c = 0; c < size; ++c)
            t.row(c) *= channel_factor(parameters, channels[static_cast<std::size_t>(c)], frequency);
        expected.matrix(b) += t * psd(frequency) * t.adjoint();
    }
}

bool has_own_forces(const pem::CaseParameters& parameters) {
    return !parameters.modifiers.primary_forces.empty() || !parameters.modifiers.secondary_forces.empty();
}

void add_own_forces(const pem::CaseParameters& parameters, const SolvedLines& solved,
                    const std::vector<ObservedChannel>& channels, double bin_hz, ExpectedSpectra& expected) {
    const auto add = [&](vehicle::Law law, long elements, const pem::ForceSpectrum& force) {
        if (force.empty()) return;
        add_inner_forces(
            parameters, solved, law,
            [&](double f) { return RowMatrix(force.at(f) * RowMatrix::Identity(elements, elements)); }, channels,
            bin_hz, expected);
    };
    add(vehicle::Law::primary, 4, parameters.modifiers.primary_forces);
    add(vehicle::Law::secondary, 2, parameters.modifiers.secondary_forces);
}

}  // namespace railpem::diagnosis

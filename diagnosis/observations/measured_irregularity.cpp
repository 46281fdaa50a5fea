#include "diagnosis/observations/measured_irregularity.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/observations/observation_options.hpp"
#include "spectra/irregularity_spectrum.hpp"

namespace railpem::diagnosis {

namespace {

/// One measurement's belief between two wavenumbers.
NodeBelief belief_between(const spectra::IrregularityParameters& believed,
                          const recordings::MeasuredIrregularity& measured, double low, double high) {
    const std::vector<double>& n = measured.cycles_per_m;
    if (n.empty() || n.front() > low / kObservationSettings.covered_share ||
        n.back() < kObservationSettings.covered_share * high)
        return {};
    double own = 0.0, expected = 0.0;
    std::size_t lines = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        if (n[i] < low || n[i] > high) continue;
        const double width = 0.5 * (n[std::min(i + 1, n.size() - 1)] - n[i > 0 ? i - 1 : 0]);
        own += measured.psd_m3[i] * width;
        expected += spectra::irregularity_psd_m3(believed, n[i]) * width;
        ++lines;
    }
    if (lines == 0 && !measured.is_profile()) {  // a coarse table: its two neighbours
        const std::size_t next =
            static_cast<std::size_t>(std::lower_bound(n.begin(), n.end(), std::sqrt(low * high)) - n.begin());
        if (next == 0 || next == n.size()) return {};
        const double centre = std::sqrt(low * high),
                     share = std::log(centre / n[next - 1]) / std::log(n[next] / n[next - 1]);
        own = std::exp((1.0 - share) * std::log(measured.psd_m3[next - 1]) + share * std::log(measured.psd_m3[next]));
        expected = spectra::irregularity_psd_m3(believed, centre);
    }
    if (!(own > 0.0) || !(expected > 0.0)) return {};
    const double deviation = measured.is_profile() ? 1.0 / std::sqrt(measured.averages * static_cast<double>(lines))
                                                   : kObservationSettings.table_deviation;
    return {std::log(own / expected), std::max(kObservationSettings.least_node_deviation, deviation), true};
}

}  // namespace

std::vector<NodeBelief> node_beliefs(const spectra::IrregularityParameters& believed,
                                     const std::vector<recordings::MeasuredIrregularity>& measured,
                                     const std::vector<double>& wavelengths_m) {
    std::vector<NodeBelief> beliefs(wavelengths_m.size());
    for (std::size_t i = 0; i < wavelengths_m.size() && wavelengths_m.size() > 1; ++i) {
        const double step = i > 0 ? wavelengths_m[i] / wavelengths_m[i - 1] : wavelengths_m[1] / wavelengths_m[0],
                     half = std::sqrt(step);
        // The ends of the band lie in the middle of their node's reach: only the inner half is asked for.
        const double low = 1.0 / (wavelengths_m[i] * (i + 1 < wavelengths_m.size() ? half : 1.0)),
                     high = 1.0 / wavelengths_m[i] * (i > 0 ? half : 1.0);
        double precision = 0.0, sum = 0.0;
        for (const recordings::MeasuredIrregularity& own : measured)
            if (const NodeBelief belief = belief_between(believed, own, low, high); belief.measured) {
                precision += 1.0 / (belief.deviation * belief.deviation);
                sum += belief.mean / (belief.deviation * belief.deviation);
            }
        if (precision > 0.0)
            beliefs[i] = {sum / precision,
                          std::max(kObservationSettings.least_node_deviation, 1.0 / std::sqrt(precision)), true};
    }
    return beliefs;
}

}  // namespace railpem::diagnosis

#include "diagnosis/decay_rate_reference.hpp"

#include <cmath>
#include <map>

namespace railpem::diagnosis {

namespace {

int band_of(double frequency_hz) {
    return static_cast<int>(std::lround(10.0 * std::log10(frequency_hz)));
}

/// Logarithms of recorded by predicted, weighted by what each is known to.
struct BandSum {
    double weights = 0.0, logs = 0.0;
};

}  // namespace

int reference_band(const pem::DecayRateReference& reference, double frequency_hz) {
    for (std::size_t i = 0; i < reference.centre_hz.size(); ++i)
        if (band_of(reference.centre_hz[i]) == band_of(frequency_hz)) return static_cast<int>(i);
    return -1;
}

pem::DecayRateReference decay_rate_reference(const Trial& trial, const Predictions& predictions,
                                             const std::vector<Observation>& observations) {
    const pem::DecayRateReference& before = trial.numbers.decay_rate_reference;
    std::map<double, BandSum> sums;
    for (std::size_t o = 0; o < observations.size(); ++o) {
        if (!observations[o].scalar || observations[o].scalar->kind != recordings::RecordingKind::decay_rate) continue;
        for (std::size_t i = 0; i < observations[o].scalar->values.size(); ++i) {
            const ScalarValue& value = observations[o].scalar->values[i];
            const int known = reference_band(before, value.frequency_hz);
            const double weight = 1.0 / (value.deviation * value.deviation);
            BandSum& own = sums[value.frequency_hz];
            own.weights += weight;
            own.logs += weight * ((known < 0 ? 0.0 : std::log(before.ratio[static_cast<std::size_t>(known)])) -
                                  predictions[o].values[i].real());
        }
    }
    if (sums.empty()) return before;
    pem::DecayRateReference reference;
    for (const auto& [centre, own] : sums) {
        reference.centre_hz.push_back(centre);
        reference.ratio.push_back(std::exp(own.logs / own.weights));
        reference.relative_error.push_back(1.0 / std::sqrt(own.weights));
    }
    return reference;
}

}  // namespace railpem::diagnosis

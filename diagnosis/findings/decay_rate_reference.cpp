#include "diagnosis/findings/decay_rate_reference.hpp"

#include <cmath>
#include <map>

#include "diagnosis/observations/reference_band.hpp"

namespace railpem::diagnosis {

namespace {

/// Logarithms of recorded by predicted, weighted by what each is known to.
struct BandSum {
    double weights = 0.0, logs = 0.0;
};

}  // namespace

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

#include "app/prove/calibration.hpp"

#include <algorithm>

namespace railpem::app {

namespace {

// Finer at the ends, where verdicts fall. What is improbable beyond the first edge is not counted: there is no end of
// it.
constexpr double kEdges[] = {0.01, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95, 0.99, 1.0};

std::vector<std::string> true_set(const TrialTruth& truth) {
    if (truth.kind == TrialKind::outside) return {"unknown"};
    std::vector<std::string> ids;
    for (const simulate::Hidden& hidden : truth.hidden) ids.push_back(hidden.id);
    std::sort(ids.begin(), ids.end());
    return ids;
}

}  // namespace

std::vector<CalibrationBin> calibration_curve(const std::vector<ScoredTrial>& trials) {
    std::vector<CalibrationBin> bins;
    for (std::size_t i = 0; i + 1 < std::size(kEdges); ++i) bins.push_back({.low = kEdges[i], .high = kEdges[i + 1]});
    for (const ScoredTrial& trial : trials) {
        if (trial.judgement.claim == Claim::failed) continue;
        const std::vector<std::string> hidden = true_set(*trial.truth);
        for (const diagnosis::EffectSet& set : trial.result->posterior)
            for (CalibrationBin& bin : bins) {
                const bool last = &bin == &bins.back();
                if (set.probability < bin.low || (set.probability >= bin.high && !last)) continue;
                bin.mean_probability += set.probability;
                bin.true_sets.count(set.effects == hidden);
            }
    }
    for (CalibrationBin& bin : bins)
        if (bin.true_sets.of > 0) bin.mean_probability /= static_cast<double>(bin.true_sets.of);
    return bins;
}

}  // namespace railpem::app

#include "diagnosis/model_error.hpp"

#include <algorithm>

#include "diagnosis/loaded_pads.hpp"
#include "diagnosis/repeated_misfit.hpp"

namespace railpem::diagnosis {

bool is_approximate(const FittedSet& set) {
    return std::any_of(set.effects.begin(), set.effects.end(), [](const Candidate& member) { return find_effect(member.instance.effect)->approximate; });
}

double share_left(const FittedSet& set) { return is_approximate(set) ? 0.02 : 0.005; }

double nats_left(const FittedSet& set, double retuned_score, double least) { return std::max(least, share_left(set) * (set.score() - retuned_score)); }

double misfit_left(const FittedSet& set, double retuned_score, double least) {
    return std::max(least, (is_approximate(set) ? 0.25 : 0.005) * (set.score() - retuned_score));
}

double room_beside(const Trial& trial, const LikelihoodContext& context) {
    constexpr double kPerSecond = 0.5;
    if (!load_stiffens_pads(trial)) return 0.0;
    double seconds = 0.0;
    for (const Observation& observation : *context.observations) seconds += observation.all.seconds;
    return kPerSecond * seconds;
}

Missed missed_by(const Fit& fit, const LikelihoodContext& context) {
    constexpr double kDeviations = 4.0;  // 3e-5 of normal chance
    const RepeatedMisfit misfit = repeated_misfit(fit.trial, fit.predictions, context);
    const double own_per_s = load_stiffens_pads(fit.trial) ? 60.0 : 4.0;
    return {std::max(0.0, misfit.nats - kDeviations * misfit.deviation - own_per_s * misfit.seconds), room_beside(fit.trial, context)};
}

}  // namespace railpem::diagnosis

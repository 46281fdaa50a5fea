#include "diagnosis/judge/model_error.hpp"

#include <algorithm>

#include "diagnosis/likelihood/repeated_misfit.hpp"

namespace railpem::diagnosis {

bool is_approximate(const FittedSet& set) {
    return std::any_of(set.effects.begin(), set.effects.end(),
                       [](const Candidate& member) { return find_effect(member.instance.effect)->approximate; });
}

double share_left(const FittedSet& set) {
    return is_approximate(set) ? 0.03 : 0.005;
}

double nats_left(const FittedSet& set, double retuned_score, double least) {
    return std::max(least, share_left(set) * (set.score() - retuned_score));
}

double misfit_left(const FittedSet& set, double retuned_score, double least) {
    return std::max(least, (is_approximate(set) ? 0.25 : 0.005) * (set.score() - retuned_score));
}

double missed_by(const Fit& fit, const LikelihoodContext& context) {
    constexpr double kDeviations = 4.0;  // 3e-5 of normal chance
    constexpr double kOwnPerSecond = 4.0;
    const RepeatedMisfit misfit = repeated_misfit(fit.trial, fit.predictions, context);
    return std::max(0.0, misfit.nats - kDeviations * misfit.deviation - kOwnPerSecond * misfit.seconds);
}

bool misses_much(const Fit& fit, const LikelihoodContext& context) {
    constexpr double kMuch_per_s = 100.0;
    const RepeatedMisfit misfit = repeated_misfit(fit.trial, fit.predictions, context);
    return misfit.nats >= kMuch_per_s * misfit.seconds;
}

bool is_doubtful(const FittedSet& set) {
    const auto is_structure = [](const Candidate& own) {
        return element_of(*find_effect(own.instance.effect), own.instance) != Element::sensor;
    };
    return !set.released.empty() && std::any_of(set.effects.begin(), set.effects.end(), is_structure);
}

}  // namespace railpem::diagnosis

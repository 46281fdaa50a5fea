#include "diagnosis/model_error.hpp"

#include <algorithm>

namespace railpem::diagnosis {

double share_left(const FittedSet& set) {
    const bool linearised = std::any_of(set.effects.begin(), set.effects.end(), [](const Candidate& member) { return find_effect(member.instance.effect)->linearised; });
    return linearised ? 0.02 : 0.005;
}

double nats_left(const FittedSet& set, double retuned_score, double least) { return std::max(least, share_left(set) * (set.score() - retuned_score)); }

}  // namespace railpem::diagnosis

#include "diagnosis/model_error.hpp"

#include <algorithm>

namespace railpem::diagnosis {

namespace {

bool is_linearised(const FittedSet& set) {
    return std::any_of(set.effects.begin(), set.effects.end(), [](const Candidate& member) { return find_effect(member.instance.effect)->linearised; });
}

}  // namespace

double share_left(const FittedSet& set) { return is_linearised(set) ? 0.02 : 0.005; }

double nats_left(const FittedSet& set, double retuned_score, double least) { return std::max(least, share_left(set) * (set.score() - retuned_score)); }

double misfit_left(const FittedSet& set, double retuned_score, double least) {
    return std::max(least, (is_linearised(set) ? 0.25 : 0.005) * (set.score() - retuned_score));
}

}  // namespace railpem::diagnosis

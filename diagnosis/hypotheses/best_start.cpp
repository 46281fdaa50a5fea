#include "diagnosis/hypotheses/best_start.hpp"

#include <algorithm>
#include <cmath>

namespace railpem::diagnosis {

Started best_start(const BelievedCase& believed, const Fit& near, const Starts& starts,
                   const std::vector<Candidate>& candidates, const std::vector<Candidate>& members,
                   const std::vector<std::string>& released, const LikelihoodContext& context) {
    constexpr double kParts[] = {1.0, 0.3, 0.1, 0.03, 0.01, 0.003, 0.0};
    const auto started = [&](const Promise& promise) {
        const Candidate& candidate = candidates[promise.candidate];
        Started best;
        for (const double part : kParts) {
            // the mild strength is for what cannot be reached from nothing
            if (part == 0.0 && std::isfinite(best.log_posterior)) break;
            Started own{.candidate = part == 0.0 ? candidate : started_at(candidate, part * promise.strength),
                        .near = {.trial = near.trial,
                                 .unknowns = near.unknowns,
                                 .values = near.values,
                                 .derivatives = near.derivatives}};
            for (std::size_t u = 0; u < own.near.values.size(); ++u)
                own.near.values[u] =
                    std::clamp(near.values[u] + part * promise.strength * promise.move(static_cast<long>(u)),
                               near.unknowns[u].low, near.unknowns[u].high);
            std::vector<Candidate> with = members;
            with.push_back(own.candidate);
            const Supposition supposition = suppose(believed, own.near, with, released, {}, context);
            own.log_posterior = log_posterior_at(supposition.trial, supposition.unknowns, supposition.start, context);
            if (own.log_posterior > best.log_posterior || part == 0.0) best = std::move(own);
            if (best.log_posterior > near.log_posterior) break;
        }
        return best;
    };
    Started best = started(starts.front());
    for (std::size_t i = 1; i < starts.size(); ++i)
        if (Started other = started(starts[i]); other.log_posterior > best.log_posterior) best = std::move(other);
    return best;
}

}  // namespace railpem::diagnosis

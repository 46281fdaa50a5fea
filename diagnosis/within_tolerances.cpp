#include "diagnosis/within_tolerances.hpp"

#include <algorithm>

namespace railpem::diagnosis {

namespace {

bool is_believed(const Unknown& unknown) {
    return unknown.kind == UnknownKind::number || unknown.kind == UnknownKind::irregularity || unknown.kind == UnknownKind::passing || unknown.kind == UnknownKind::speed;
}

}  // namespace

Unknown kept(Unknown unknown) {
    if (!is_believed(unknown)) return unknown;
    unknown.low = std::max(unknown.low, unknown.mean - kKeptTolerances * unknown.deviation);
    unknown.high = std::min(unknown.high, unknown.mean + kKeptTolerances * unknown.deviation);
    return unknown;
}

FittedSet fit_within_tolerances(const BelievedCase& believed, const Fit& retuned, const LikelihoodContext& context, const FitOptions& options) {
    Supposition own = suppose(believed, retuned, {}, {}, {}, context);
    for (std::size_t u = 0; u < own.unknowns.size(); ++u) {
        own.unknowns[u] = kept(std::move(own.unknowns[u]));
        own.start[u] = std::clamp(own.start[u], own.unknowns[u].low, own.unknowns[u].high);
    }
    FittedSet set;
    set.fit = fit(own.trial, std::move(own.unknowns), std::move(own.start), context, options);
    set.held_out = part_log_likelihood(set.fit, context, Part::held_out);
    return set;
}

}  // namespace railpem::diagnosis

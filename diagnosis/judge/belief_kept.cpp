#include "diagnosis/judge/belief_kept.hpp"

#include <algorithm>
#include <cmath>

namespace railpem::diagnosis {

namespace {

/// The unknowns by which retuning moves what an effect says.
UnknownKind moved_by_retuning(const Effect& effect) {
    return effect.lines_alone ? UnknownKind::passing : UnknownKind::irregularity;
}

bool is_believed(const Unknown& unknown) {
    return unknown.kind == UnknownKind::number || unknown.kind == UnknownKind::irregularity ||
           unknown.kind == UnknownKind::passing;
}

double distance_in(const Fit& fit, const Unknown& unknown) {
    std::size_t index = 0;
    return fit.find(unknown.name, &index) ? std::abs(fit.values[index] - unknown.mean) : 0.0;
}

}  // namespace

bool gives_up(const FittedSet& set, const Unknown& unknown) {
    if (unknown.kind == UnknownKind::number)
        return std::find(set.released.begin(), set.released.end(), unknown.name) != set.released.end();
    return std::any_of(set.effects.begin(), set.effects.end(), [&](const Candidate& member) {
        const Effect& effect = *find_effect(member.instance.effect);
        return effect.retuned && moved_by_retuning(effect) == unknown.kind;
    });
}

Unknown kept(Unknown unknown, double reach) {
    const double within = std::max(reach, kKeptTolerances * unknown.deviation);
    unknown.low = std::max(unknown.low, unknown.mean - within);
    unknown.high = std::min(unknown.high, unknown.mean + within);
    return unknown;
}

std::optional<FittedSet> fit_belief_kept(const BelievedCase& believed, const Fit& retuned, const FittedSet& set,
                                         const LikelihoodContext& context, const FitOptions& options) {
    Supposition own = suppose(believed, retuned, {}, {}, {}, context);
    for (std::size_t u = 0; u < own.unknowns.size(); ++u) {
        if (!is_believed(own.unknowns[u])) continue;
        own.unknowns[u] =
            kept(own.unknowns[u], gives_up(set, own.unknowns[u]) ? 0.0 : distance_in(set.fit, own.unknowns[u]));
        own.start[u] = std::clamp(own.start[u], own.unknowns[u].low, own.unknowns[u].high);
    }
    FittedSet result;
    result.fit = fit(own.trial, std::move(own.unknowns), std::move(own.start), context, options);
    if (!std::isfinite(result.fit.log_posterior)) return std::nullopt;
    result.fit.derivatives.reset();  // nothing starts from there
    result.held_out = part_log_likelihood(result.fit, context, Part::held_out);
    return result;
}

}  // namespace railpem::diagnosis

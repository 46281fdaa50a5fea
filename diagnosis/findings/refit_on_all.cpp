#include "diagnosis/findings/refit_on_all.hpp"

#include "diagnosis/fit/fit_settings.hpp"
#include "diagnosis/fit/robust_covariance.hpp"
#include "diagnosis/judge/belief_kept.hpp"

namespace railpem::diagnosis {

namespace {

/// nats, for the last step is undamped: further ones rattle by what differences are off (both effects of the paper:
/// 0.2, 0.5 and 0.04)
constexpr double kRefitGain = 0.5;

}  // namespace

Refitted refit_on_all(const BelievedCase& believed, const LikelihoodContext& context, const NamingResult& naming,
                      const PlaceStudy& study, const Decision& decision) {
    LikelihoodContext all = context;
    all.part = Part::all;
    const FitOptions near{.least_gain = kRefitGain, .from_far = false};
    FitOptions retuning = near;
    retuning.patience = kFitSettings.retuning_patience;
    Refitted refitted;
    refitted.retuned = fit_set(believed, naming.retuned.fit, {}, {}, {}, all, retuning);
    refitted.named = decision.named ? fit_set(believed, decision.named->fit, decision.named->effects,
                                              decision.named->released, {}, all, near)
                                    : refitted.retuned;
    refitted.named.fit.covariance = robust_covariance(refitted.named.fit, all);
    if (decision.verdict != Verdict::explained || !study.belief_kept) return refitted;
    refitted.kept = fit_belief_kept(believed, study.belief_kept->fit, refitted.named, all, retuning);
    if (!refitted.kept) refitted.kept = study.belief_kept;
    return refitted;
}

}  // namespace railpem::diagnosis

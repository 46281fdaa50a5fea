#include "diagnosis/search/keep_beliefs.hpp"

#include "diagnosis/fit/fit_settings.hpp"
#include "diagnosis/judge/belief_kept.hpp"

namespace railpem::diagnosis {

void keep_beliefs(const Inquiry& inquiry, NamingResult& naming, PlaceStudy& study) {
    const std::size_t before = naming.sets.size();
    HeldBeliefs held = drop_unfounded_beliefs(naming, inquiry.thresholds, [&](const FittedSet& set) {
        inquiry.say("the case that keeps what was believed", 0.755);
        return fit_belief_kept(inquiry.believed, naming.retuned.fit, set, inquiry.context,
                               {.patience = kFitSettings.retuning_patience});
    });
    study.belief_kept = std::move(held.of_best);
    study.unfounded.insert(study.unfounded.end(), held.unfounded.begin(), held.unfounded.end());
    if (naming.sets.size() != before) naming.left_by_best.clear();  // perhaps of a set that is gone
}

}  // namespace railpem::diagnosis

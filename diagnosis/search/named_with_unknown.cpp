#include "diagnosis/search/named_with_unknown.hpp"

#include <algorithm>

#include "diagnosis/model/effort.hpp"
#include "diagnosis/search/study_places.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kRest = 0.5;  ///< of what a name explains, that an unknown of its place may explain beyond it
/// times the effort of the search, after which nothing is tried beside an unknown any more
constexpr double kBesideUnknown = 1.6;

}  // namespace

void weigh_named_with_unknown(const Inquiry& inquiry, NamingResult& naming, PlaceStudy& study) {
    if (naming.sets.empty() || study.anonymous.empty()) return;
    FittedSet& best = naming.sets.front();
    const auto lower = [](const FittedSet& a, const FittedSet& b) { return a.score() < b.score(); };
    const FittedSet& unknown = *std::max_element(study.anonymous.begin(), study.anonymous.end(), lower);
    if (unknown.score() < best.score() + inquiry.thresholds.anonymous) return;
    const Element element = unknown.anonymous.front().element;
    if (sits_at(best, element) && unknown.score() - best.score() < kRest * (best.score() - naming.retuned.score()))
        return;
    if (!could_stand_beside(best, naming.retuned.score(), inquiry.thresholds)) return;  // whatever it explains
    if (is_spent(inquiry, kBesideUnknown))
        return naming.not_tested.push_back(
            left_out_for_effort("the named beside the unknown", *inquiry.context.effort,
                                effort_allowed(inquiry.observations, inquiry.naming.effort_s)));
    inquiry.say("the named beside the unknown", 0.91);
    for (const LocatedEvidence& own : left_by_best(inquiry, naming))
        if (own.place.element == element)
            study.named_stands =
                fit_correction(inquiry.believed, best, own, inquiry.context,
                               {.iterations = kAnonymousIterations, .least_gain = kAnonymousGain, .from_far = false})
                    .score() > unknown.score() + inquiry.thresholds.least_gain;
}

}  // namespace railpem::diagnosis

#include "diagnosis/search/study_places.hpp"

#include <algorithm>
#include <memory>

#include "diagnosis/judge/repeated_levels.hpp"
#include "diagnosis/judge/scalar_levels.hpp"
#include "diagnosis/model/effort.hpp"
#include "diagnosis/search/from_afar.hpp"

namespace railpem::diagnosis {

namespace {

constexpr int kAnonymousFits = 2;  ///< places whose free correction is fitted in full, at most
/// nats that a free correction beside a name promises: no other way to what the name explains would beat it by the 3 of
/// VerdictThresholds::anonymous, were the name's own freedom worth 8
constexpr double kNothingLeft = -5.0;
/// nats that a correction may stay behind the named set and still draw its curve
constexpr double kRoomForCurve = 300.0;

std::vector<PlaceEvidence> evidence(const std::vector<LocatedEvidence>& located) {
    std::vector<PlaceEvidence> result;
    for (const LocatedEvidence& own : located)
        result.push_back({.element = own.place.element, .nats = own.nats, .forces = own.place.forces});
    return result;
}

/// By how much the levels of a fit are off, beyond chance and stated errors.
double level_db(const Fit& fit, const LikelihoodContext& context) {
    return std::max(repeated_level_db(fit, context), scalar_level_db(fit, context));
}

/// What the best set leaves, and how well it holds.
void study_named(const Inquiry& inquiry, NamingResult& naming, PlaceStudy& study) {
    FittedSet& best = naming.sets.front();
    const std::shared_ptr<const Derivatives> kept = best.fit.derivatives;
    restore_caches(best.fit, inquiry.context);
    restore_derivatives(best.fit, inquiry.context);
    study.by_named = missed_by(best.fit, inquiry.context);
    study.named_level_db = level_db(best.fit, inquiry.context);
    study.by_recording = constancy(best.fit, inquiry.context);
    if (names_friction(best)) study.friction = friction_law(best.fit, inquiry.context);
    if (best.score() > naming.retuned.score() + gain_asked(best, inquiry.thresholds))
        study.at_named = evidence(left_by_best(inquiry, naming));
    best.fit.derivatives = kept;  // a megabyte for every unknown and recording, which a free correction needs
}

/// Retuning leaves so much that no promise at its end says where to, and what was named does not stand.
bool leaves_much(const Inquiry& inquiry, const NamingResult& naming, const PlaceStudy& study) {
    // without time series nothing is known of it
    if (study.by_retuned <= inquiry.thresholds.residual || !misses_much(naming.retuned.fit, inquiry.context))
        return false;
    if (naming.sets.empty()) return true;
    const FittedSet& best = naming.sets.front();
    const double nothing = naming.retuned.score(), residual = inquiry.thresholds.residual;
    return best.score() <= nothing + gain_asked(best, inquiry.thresholds) || leans(best, nothing) ||
           needs_wrong_numbers(best, inquiry.thresholds) || study.by_named > misfit_left(best, nothing, residual) ||
           (!study.at_named.empty() && study.at_named.front().nats > nats_left(best, nothing, residual));
}

/// A set beyond its range; what the search has fitted of it is not fitted again.
std::optional<FittedSet> beyond_range(const Inquiry& inquiry, const FittedSet& leaning, NamingResult& naming) {
    const Candidate* member = leaning_member(inquiry.believed, leaning);
    if (member && naming.beyond && same_variant(naming.beyond->effects.front().instance, member->instance))
        return std::move(naming.beyond);
    return fit_beyond_range(inquiry.believed, leaning, inquiry.context, {});
}

/// Free corrections from the believed numbers on, and the best set beyond its range where it is on the end of that.
void correct_from_afar(const Inquiry& inquiry, NamingResult& naming, PlaceStudy& study) {
    const auto between = [&](const std::string& what) { inquiry.say(what, 0.85); };
    if (naming.blunt_corrections.sets.empty())
        naming.blunt_corrections = blunt_corrections(inquiry.believed, inquiry.context, between);
    std::optional<FittedSet> beyond;
    if (!naming.sets.empty() && leans(naming.sets.front(), naming.retuned.score()))
        beyond = beyond_range(inquiry, naming.sets.front(), naming);
    study.anonymous = sharpened_corrections(
        inquiry.believed, naming.blunt_corrections, inquiry.context, between, [&] { return is_spent(inquiry, 1.0); },
        beyond ? &beyond->fit : nullptr);
    if (beyond) study.anonymous.push_back(std::move(*beyond));
}

/// Beside the best set a place's free correction is not nearly worth its freedom: in its place it does not outdo it
/// either, for beside it that would explain no less. Where it shows a curve, at the places of the set, it is fitted
/// all the same.
bool nothing_is_left_at(const PlaceStudy& study, Element element) {
    const auto own = std::find_if(study.at_named.begin(), study.at_named.end(),
                                  [&](const PlaceEvidence& evidence) { return evidence.element == element; });
    return own != study.at_named.end() && own->nats < kNothingLeft;
}

bool is_named_place(const FittedSet& best, Element element) {
    // rigid ground has no correction of its own
    return sits_at(best, element) || (element == Element::pad && sits_at(best, Element::support));
}

/// Free corrections of the places that promise most, from the retuned case on.
void correct_from_retuned(const Inquiry& inquiry, const NamingResult& naming, PlaceStudy& study) {
    int fitted = 0;
    for (const LocatedEvidence& own : naming.left_by_retuned) {
        if (fitted == kAnonymousFits || own.nats < inquiry.naming.least_promise) break;
        if (nothing_is_left_at(study, own.place.element) && !is_named_place(naming.sets.front(), own.place.element))
            continue;
        inquiry.say("free correction of the " + element_name(own.place.element), 0.82 + 0.05 * fitted++);
        // Where retuning misses much, most cannot come near what is named, and a blunt likelihood sees that in less
        // than half the time.
        FitOptions fit_options{.iterations = kAnonymousIterations,
                               .least_gain = kAnonymousGain,
                               .from_far = misses_much(naming.retuned.fit, inquiry.context)};
        if (!naming.sets.empty()) fit_options.rival = &naming.sets.front().fit, fit_options.room = kRoomForCurve;
        study.anonymous.push_back(fit_correction(inquiry.believed, naming.retuned, own, inquiry.context, fit_options));
    }
}

}  // namespace

bool sits_at(const FittedSet& set, Element element) {
    const std::vector<Element> own = elements_of(set, nullptr);
    return std::find(own.begin(), own.end(), element) != own.end();
}

bool is_spent(const Inquiry& inquiry, double times) {
    return inquiry.context.effort->seconds() > times * effort_allowed(inquiry.observations, inquiry.naming.effort_s);
}

const std::vector<LocatedEvidence>& left_by_best(const Inquiry& inquiry, NamingResult& naming) {
    if (naming.left_by_best.empty()) naming.left_by_best = locate(naming.sets.front().fit, inquiry.context);
    return naming.left_by_best;
}

void study_places(const Inquiry& inquiry, NamingResult& naming, PlaceStudy& study) {
    inquiry.say("locating in the structure", 0.76);
    if (naming.left_by_retuned.empty()) naming.left_by_retuned = locate(naming.retuned.fit, inquiry.context);
    study.at_retuned = evidence(naming.left_by_retuned);
    study.by_retuned = missed_by(naming.retuned.fit, inquiry.context);
    study.retuned_level_db = level_db(naming.retuned.fit, inquiry.context);
    if (!naming.sets.empty()) study_named(inquiry, naming, study);
    if (leaves_much(inquiry, naming, study))
        correct_from_afar(inquiry, naming, study);
    else
        correct_from_retuned(inquiry, naming, study);
}

}  // namespace railpem::diagnosis

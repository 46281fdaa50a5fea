#include "diagnosis/diagnose.hpp"

#include <algorithm>
#include <chrono>
#include <memory>

#include "diagnosis/findings/write_up.hpp"
#include "diagnosis/fit/robust_covariance.hpp"
#include "diagnosis/hypotheses/locate.hpp"
#include "diagnosis/judge/belief_kept.hpp"
#include "diagnosis/judge/ground_resonance.hpp"
#include "diagnosis/judge/model_error.hpp"
#include "diagnosis/judge/repeated_levels.hpp"
#include "diagnosis/judge/verdict.hpp"
#include "diagnosis/model/effort.hpp"
#include "diagnosis/model/wheel_unloading.hpp"
#include "diagnosis/search/from_afar.hpp"
#include "diagnosis/search/hold_again.hpp"
#include "diagnosis/search/name_physics.hpp"

namespace railpem::diagnosis {

namespace {

constexpr int kAnonymousFits = 2;  ///< places whose free correction is fitted in full, at most
/// nats that a free correction beside a name promises: no other way to what the name explains would beat it by the 3 of
/// VerdictThresholds::anonymous, were the name's own freedom worth 8
constexpr double kNothingLeft = -5.0;
constexpr int kAnonymousIterations = 12;
constexpr double kRest = 0.5;  ///< of what a name explains, that an unknown of its place may explain beyond it
/// times the effort of the search, after which nothing is tried beside an unknown any more
constexpr double kBesideUnknown = 1.6;
constexpr double kAnonymousGain = 1.0;  ///< nats: a score that decides between names within 3 needs no more
/// nats, for the last step is undamped: further ones rattle by what differences are off (both effects of the paper:
/// 0.2, 0.5 and 0.04)
constexpr double kRefitGain = 0.5;
/// nats that a correction may stay behind the named set and still draw its curve
constexpr double kRoomForCurve = 300.0;

class Diagnosing {
  public:
    Diagnosing(const BelievedCase& believed, const std::vector<Observation>& observations,
               const DiagnoseOptions& options)
        : believed_(believed),
          observations_(observations),
          left_out_(leave_out_unloaded(observations_)),
          coarse_(coarse_observations(observations_)),
          options_(options),
          context_{.believed = &believed_,
                   .observations = &observations_,
                   .coarse = &coarse_,
                   .part = Part::fitted,
                   .least_floor = 0.0,
                   .threads = options.threads,
                   .effort = &effort_} {}

    Diagnosis run() {
        const auto begin = std::chrono::steady_clock::now();
        NamingOptions naming = options_.naming;
        naming.progress = [this](const std::string& what, double share) { say(what, 0.75 * share); };
        naming.interrupted = options_.interrupted;
        naming_ = name_physics(believed_, context_, naming);
        result_.interrupted = naming_.interrupted;
        if (naming_.retuned.fit.unknowns.empty()) {  // ended before anything was known
            result_.statement = "Interrupted before the case was retuned: nothing is known.";
            return std::move(result_);
        }
        // it was of a set that is gone
        if (drop_superfluous(naming_, options_.thresholds)) naming_.left_by_best.clear();
        // of `consistent`, nor of a name
        const bool has_no_chance = naming_.sets.empty() && misses_much(naming_.retuned.fit, context_);
        keep_beliefs();
        if (!naming_.interrupted && !has_no_chance && rests_on_held_forces(naming_, believed_)) hold_again();
        study_places();
        try_beside();
        tell_ground_from_pads(study_);  // only now: beside a name it is fitted at the pads
        const Decision decision = decide(naming_, study_, options_.thresholds);
        say("refitting on everything", 0.92);
        refit(decision);
        write_up({.believed = believed_,
                  .observations = observations_,
                  .context = context_,
                  .thresholds = options_.thresholds,
                  .naming = naming_,
                  .study = study_,
                  .decision = decision,
                  .retuned = retuned_,
                  .kept = kept_ ? &*kept_ : nullptr,
                  .named = named_},
                 result_);
        result_.remains.insert(result_.remains.end(), left_out_.begin(), left_out_.end());
        result_.seconds_taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return std::move(result_);
    }

  private:
    void say(const std::string& what, double share) {
        if (options_.progress) options_.progress(what, share);
    }

    static std::vector<PlaceEvidence> evidence(const std::vector<LocatedEvidence>& located) {
        std::vector<PlaceEvidence> result;
        for (const LocatedEvidence& own : located)
            result.push_back({.element = own.place.element, .nats = own.nats, .forces = own.place.forces});
        return result;
    }

    /// Whether a multiple of the effort that the search is allowed is spent.
    bool is_spent(double times) const { return effort_.seconds() > times * allowed_s(); }
    double allowed_s() const { return effort_allowed(observations_, options_.naming.effort_s); }

    void hold_again() {
        say("the contacts under the forces that were found", 0.75);
        observations_ = held_again(best_of(naming_), believed_, observations_);
        coarse_ = coarse_observations(observations_);
        fit_again(naming_, believed_, context_);
        naming_.beyond.reset();  // of the forces before
        drop_superfluous(naming_, options_.thresholds);
        keep_beliefs();
    }

    /// What only gives up beliefs is held against the case that keeps them.
    void keep_beliefs() {
        const std::size_t before = naming_.sets.size();
        HeldBeliefs held = drop_unfounded_beliefs(naming_, options_.thresholds, [this](const FittedSet& set) {
            say("the case that keeps what was believed", 0.755);
            return fit_belief_kept(believed_, naming_.retuned.fit, set, context_,
                                   {.patience = kFitSettings.retuning_patience});
        });
        study_.belief_kept = std::move(held.of_best);
        study_.unfounded.insert(study_.unfounded.end(), held.unfounded.begin(), held.unfounded.end());
        if (naming_.sets.size() != before) naming_.left_by_best.clear();  // perhaps of a set that is gone
    }

    void study_places() {
        say("locating in the structure", 0.76);
        if (naming_.left_by_retuned.empty()) naming_.left_by_retuned = locate(naming_.retuned.fit, context_);
        const std::vector<LocatedEvidence>& ranked = naming_.left_by_retuned;
        study_.at_retuned = evidence(ranked);
        study_.by_retuned = missed_by(naming_.retuned.fit, context_);
        if (!naming_.sets.empty()) study_named(naming_.sets.front());
        if (leaves_much()) {
            const auto between = [this](const std::string& what) { say(what, 0.85); };
            if (naming_.blunt_corrections.sets.empty())
                naming_.blunt_corrections = blunt_corrections(believed_, context_, between);
            std::optional<FittedSet> beyond;
            if (!naming_.sets.empty() && leans(naming_.sets.front(), naming_.retuned.score()))
                beyond = beyond_range(naming_.sets.front());
            study_.anonymous = sharpened_corrections(
                believed_, naming_.blunt_corrections, context_, between, [this] { return is_spent(1.0); },
                beyond ? &beyond->fit : nullptr);
            if (beyond) study_.anonymous.push_back(std::move(*beyond));
            return;
        }
        int fitted = 0;
        for (const LocatedEvidence& own : ranked) {
            if (fitted == kAnonymousFits || own.nats < options_.naming.least_promise) break;
            if (nothing_is_left_at(own.place.element) && !is_named_place(own.place.element)) continue;
            say("free correction of the " + element_name(own.place.element), 0.82 + 0.05 * fitted++);
            // Where retuning misses much, most cannot come near what is named, and a blunt likelihood sees that in less
            // than half the time.
            FitOptions fit_options{.iterations = kAnonymousIterations,
                                   .least_gain = kAnonymousGain,
                                   .from_far = misses_much(naming_.retuned.fit, context_)};
            if (!naming_.sets.empty()) fit_options.rival = &naming_.sets.front().fit, fit_options.room = kRoomForCurve;
            study_.anonymous.push_back(fit_correction(believed_, naming_.retuned, own, context_, fit_options));
        }
    }

    /// What the best set leaves, and how well it holds.
    void study_named(FittedSet& best) {
        const std::shared_ptr<const Derivatives> kept = best.fit.derivatives;
        restore_caches(best.fit, context_);
        restore_derivatives(best.fit, context_);
        study_.by_named = missed_by(best.fit, context_);
        study_.named_level_db = repeated_level_db(best.fit, observations_);
        study_.by_recording = constancy(best.fit, context_);
        if (names_friction(best)) study_.friction = friction_law(best.fit, context_);
        if (best.score() > naming_.retuned.score() + gain_asked(best, options_.thresholds))
            study_.at_named = evidence(left_by_best());
        best.fit.derivatives = kept;  // a megabyte for every unknown and recording, which a free correction needs
    }

    /// Beside the best set a place's free correction is not nearly worth its freedom: in its place it does not outdo it
    /// either, for beside it that would explain no less. Where it shows a curve, at the places of the set, it is fitted
    /// all the same.
    bool nothing_is_left_at(Element element) const {
        const auto own = std::find_if(study_.at_named.begin(), study_.at_named.end(),
                                      [&](const PlaceEvidence& evidence) { return evidence.element == element; });
        return own != study_.at_named.end() && own->nats < kNothingLeft;
    }

    static bool sits_at(const FittedSet& set, Element element) {
        const std::vector<Element> own = elements_of(set, nullptr);
        return std::find(own.begin(), own.end(), element) != own.end();
    }

    bool is_named_place(Element element) const {
        const FittedSet& best = naming_.sets.front();
        // rigid ground has no correction of its own
        return sits_at(best, element) || (element == Element::pad && sits_at(best, Element::support));
    }

    const std::vector<LocatedEvidence>& left_by_best() {
        if (naming_.left_by_best.empty()) naming_.left_by_best = locate(naming_.sets.front().fit, context_);
        return naming_.left_by_best;
    }

    /// A set beyond its range; what the search has fitted of it is not fitted again.
    std::optional<FittedSet> beyond_range(const FittedSet& leaning) {
        const Candidate* member = leaning_member(believed_, leaning);
        if (member && naming_.beyond && same_variant(naming_.beyond->effects.front().instance, member->instance))
            return std::move(naming_.beyond);
        return fit_beyond_range(believed_, leaning, context_, {});
    }

    /// Retuning leaves so much that no promise at its end says where to, and what was named does not stand.
    bool leaves_much() const {
        // without time series nothing is known of it
        if (study_.by_retuned <= options_.thresholds.residual || !misses_much(naming_.retuned.fit, context_))
            return false;
        if (naming_.sets.empty()) return true;
        const FittedSet& best = naming_.sets.front();
        const double nothing = naming_.retuned.score(), residual = options_.thresholds.residual;
        return best.score() <= nothing + gain_asked(best, options_.thresholds) || leans(best, nothing) ||
               needs_wrong_numbers(best, options_.thresholds) ||
               study_.by_named > misfit_left(best, nothing, residual) ||
               (!study_.at_named.empty() && study_.at_named.front().nats > nats_left(best, nothing, residual));
    }

    /// What an unknown outdoes may still stand beside it, if both together outdo the unknown alone: of a bump stop
    /// friction and a rougher track were all that could be named, and neither was there. Or if it has most of what an
    /// unknown of its own place explains: dampers of the rail to 3 kHz were, with 10 of 14 nats.
    void try_beside() {
        if (naming_.sets.empty() || study_.anonymous.empty()) return;
        FittedSet& best = naming_.sets.front();
        const auto lower = [](const FittedSet& a, const FittedSet& b) { return a.score() < b.score(); };
        const FittedSet& unknown = *std::max_element(study_.anonymous.begin(), study_.anonymous.end(), lower);
        if (unknown.score() < best.score() + options_.thresholds.anonymous) return;
        const Element element = unknown.anonymous.front().element;
        if (sits_at(best, element) && unknown.score() - best.score() < kRest * (best.score() - naming_.retuned.score()))
            return;
        if (!could_stand_beside(best, naming_.retuned.score(), options_.thresholds)) return;  // whatever it explains
        if (is_spent(kBesideUnknown))
            return naming_.not_tested.push_back(
                left_out_for_effort("the named beside the unknown", effort_, allowed_s()));
        say("the named beside the unknown", 0.91);
        for (const LocatedEvidence& own : left_by_best())
            if (own.place.element == element)
                study_.named_stands =
                    fit_correction(
                        believed_, best, own, context_,
                        {.iterations = kAnonymousIterations, .least_gain = kAnonymousGain, .from_far = false})
                        .score() > unknown.score() + options_.thresholds.least_gain;
    }

    /// The retuned case and the named one, refitted on all of the recordings.
    void refit(const Decision& decision) {
        LikelihoodContext all = context_;
        all.part = Part::all;
        FitOptions retuning = near_;
        retuning.patience = kFitSettings.retuning_patience;
        retuned_ = fit_set(believed_, naming_.retuned.fit, {}, {}, {}, all, retuning);
        named_ = decision.named ? fit_set(believed_, decision.named->fit, decision.named->effects,
                                          decision.named->released, {}, all, near_)
                                : retuned_;
        named_.fit.covariance = robust_covariance(named_.fit, all);
        if (decision.verdict != Verdict::explained || !study_.belief_kept) return;
        kept_ = fit_belief_kept(believed_, study_.belief_kept->fit, named_, all, retuning);
        if (!kept_) kept_ = study_.belief_kept;
    }

    const BelievedCase& believed_;
    std::vector<Observation> observations_;
    std::vector<std::string> left_out_;  ///< recordings, and why
    std::vector<Observation> coarse_;
    const DiagnoseOptions& options_;
    Effort effort_;
    LikelihoodContext context_;
    const FitOptions near_{.least_gain = kRefitGain, .from_far = false};
    NamingResult naming_;
    PlaceStudy study_;
    FittedSet retuned_, named_;
    std::optional<FittedSet> kept_;  ///< the rival of a verdict of beliefs alone, refitted like those
    Diagnosis result_;
};

}  // namespace

Diagnosis diagnose(const BelievedCase& believed, const std::vector<Observation>& observations,
                   const DiagnoseOptions& options) {
    return Diagnosing(believed, observations, options).run();
}

}  // namespace railpem::diagnosis

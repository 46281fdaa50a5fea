#include "diagnosis/diagnose.hpp"

#include <chrono>

#include "diagnosis/findings/refit_on_all.hpp"
#include "diagnosis/findings/say_spoiled.hpp"
#include "diagnosis/findings/write_up.hpp"
#include "diagnosis/judge/ground_resonance.hpp"
#include "diagnosis/judge/model_error.hpp"
#include "diagnosis/judge/spoiled_values.hpp"
#include "diagnosis/judge/verdict.hpp"
#include "diagnosis/model/effort.hpp"
#include "diagnosis/model/wheel_unloading.hpp"
#include "diagnosis/search/hold_again.hpp"
#include "diagnosis/search/inquiry.hpp"
#include "diagnosis/search/keep_beliefs.hpp"
#include "diagnosis/search/name_physics.hpp"
#include "diagnosis/search/named_with_unknown.hpp"
#include "diagnosis/search/study_places.hpp"

namespace railpem::diagnosis {

namespace {

/// The recordings that can be diagnosed.
struct Usable {
    explicit Usable(const std::vector<Observation>& all)
        : observations(all), left_out(leave_out_unloaded(observations)), coarse(coarse_observations(observations)) {}

    std::vector<Observation> observations;
    std::vector<std::string> left_out;  ///< recordings, and why
    std::vector<Observation> coarse;    ///< the same in short windows
};

/// Retunes the believed case and searches for the sets of effects that explain what is left.
NamingResult retune_and_search(const Inquiry& inquiry, const DiagnoseOptions& options) {
    NamingOptions naming = options.naming;
    naming.progress = [&](const std::string& what, double share) { inquiry.say(what, 0.75 * share); };
    naming.interrupted = options.interrupted;
    NamingResult result = name_physics(inquiry.believed, inquiry.context, naming);
    // what the best leaves was asked of a set that is gone then
    if (drop_superfluous(result, options.thresholds)) result.left_by_best.clear();
    return result;
}

/// What was found, with the contacts under the forces that were found.
void relinearise(const Inquiry& inquiry, Usable& usable, NamingResult& naming, PlaceStudy& study) {
    inquiry.say("the contacts under the forces that were found", 0.75);
    usable.observations = held_again(best_of(naming), inquiry.believed, usable.observations);
    usable.coarse = coarse_observations(usable.observations);
    fit_again(naming, inquiry.believed, inquiry.context);
    naming.beyond.reset();  // of the forces before
    drop_superfluous(naming, inquiry.thresholds);
    keep_beliefs(inquiry, naming, study);
}

/// Beliefs weighed, contacts re-linearised, the structure searched: everything that the verdict is made of.
PlaceStudy judge(const Inquiry& inquiry, Usable& usable, NamingResult& naming) {
    PlaceStudy study;
    // of `consistent`, nor of a name
    const bool has_no_chance = naming.sets.empty() && misses_much(naming.retuned.fit, inquiry.context);
    keep_beliefs(inquiry, naming, study);
    if (!naming.interrupted && !has_no_chance && rests_on_held_forces(naming, inquiry.believed))
        relinearise(inquiry, usable, naming, study);
    study_places(inquiry, naming, study);
    weigh_named_with_unknown(inquiry, naming, study);
    tell_ground_from_pads(study);  // only now: beside a name it is fitted at the pads
    return study;
}

Diagnosis nothing_known(bool interrupted) {
    Diagnosis result;
    result.interrupted = interrupted;
    result.statement = "Interrupted before the case was retuned: nothing is known.";
    return result;
}

Diagnosis written_up(const Inquiry& inquiry, const NamingResult& naming, const PlaceStudy& study,
                     const Decision& decision, const Refitted& refitted) {
    Diagnosis result;
    result.interrupted = naming.interrupted;
    write_up({.believed = inquiry.believed,
              .observations = inquiry.observations,
              .context = inquiry.context,
              .thresholds = inquiry.thresholds,
              .naming = naming,
              .study = study,
              .decision = decision,
              .retuned = refitted.retuned,
              .kept = refitted.kept ? &*refitted.kept : nullptr,
              .named = refitted.named},
             result);
    return result;
}

}  // namespace

Diagnosis diagnose(const BelievedCase& believed, const std::vector<Observation>& observations,
                   const DiagnoseOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<Observation> as_meant = observations;
    const std::vector<SpoiledChannel> spoiled = undo_spoiling(believed, as_meant);
    Usable usable(as_meant);
    Effort effort;
    const LikelihoodContext context{.believed = &believed,
                                    .observations = &usable.observations,
                                    .coarse = &usable.coarse,
                                    .part = Part::fitted,
                                    .least_floor = 0.0,
                                    .threads = options.threads,
                                    .effort = &effort};
    const auto say = [&](const std::string& what, double share) {
        if (options.progress) options.progress(what, share);
    };
    const Inquiry inquiry{believed, usable.observations, context, options.naming, options.thresholds, say};

    NamingResult naming = retune_and_search(inquiry, options);
    if (naming.retuned.fit.unknowns.empty()) return nothing_known(naming.interrupted);
    const PlaceStudy study = judge(inquiry, usable, naming);
    const Decision decision = decide(naming, study, options.thresholds);
    say("refitting on everything", 0.92);
    const Refitted refitted = refit_on_all(believed, context, naming, study, decision);
    Diagnosis result = written_up(inquiry, naming, study, decision, refitted);
    result.remains.insert(result.remains.end(), usable.left_out.begin(), usable.left_out.end());
    say_spoiled(spoiled, result);
    result.seconds_taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace railpem::diagnosis

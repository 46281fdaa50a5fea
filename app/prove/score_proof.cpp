#include "app/prove/score_proof.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "app/prove/calibration.hpp"
#include "app/prove/detectability.hpp"

namespace railpem::app {

namespace {

/// nats per second of held-out misfit after retuning below which a share of it says nothing
constexpr double kLeastMisfit = 0.02;

template <typename Among, typename Hit>
Proportion count(const std::vector<ScoredTrial>& trials, const Among& among, const Hit& hit) {
    Proportion proportion;
    for (const ScoredTrial& trial : trials)
        if (trial.judgement.claim != Claim::failed && among(trial)) proportion.count(hit(trial));
    return proportion;
}

bool is_kind(const ScoredTrial& trial, TrialKind kind) {
    return trial.truth->kind == kind;
}
bool in_catalogue(const ScoredTrial& trial) {
    return trial.judgement.missing && !is_kind(trial, TrialKind::outside);
}
bool claims(const ScoredTrial& trial) {
    return trial.judgement.claim != Claim::nothing;
}
bool one_set(const ScoredTrial& trial) {
    return trial.judgement.claim == Claim::one_set;
}
bool right_place(const ScoredTrial& trial) {
    return trial.judgement.right_place;
}

void add_nulls_and_places(const std::vector<ScoredTrial>& trials, std::vector<Measure>& measures) {
    const auto null = [](const ScoredTrial& t) { return !t.judgement.missing; };
    const auto named = [](const ScoredTrial& t) {
        return t.judgement.claim == Claim::one_set || t.judgement.claim == Claim::several_sets;
    };
    const auto detected = [](const ScoredTrial& t) { return t.judgement.missing && claims(t); };
    const auto concealed = [](const ScoredTrial& t) { return t.judgement.concealed; };
    const auto concealed_detected = [](const ScoredTrial& t) { return t.judgement.concealed && claims(t); };
    const auto missing = [](const ScoredTrial& t) { return t.judgement.missing; };
    measures.push_back(
        {"nulls_named", "named although nothing is missing, of nulls", count(trials, null, named), 0.01, true, true});
    measures.push_back({"nulls_not_consistent", "anything but consistent, of nulls", count(trials, null, claims)});
    measures.push_back({"detected", "verdict other than consistent, of trials with something missing, however weak",
                        count(trials, missing, claims)});
    measures.push_back({"right_place", "the first place is right, of trials in which something missing was detected",
                        count(trials, detected, right_place), 0.98, false, true});
    measures.push_back({"right_place_of_all",
                        "the same of all trials with something missing, undetected ones counted as wrong",
                        count(trials, missing, right_place)});
    measures.push_back({"concealed_detected",
                        "verdict other than consistent, of concealed trials (under 0.3 dB after retuning)",
                        count(trials, concealed, claims)});
    measures.push_back({"right_place_concealed", "the first place is right, of detected concealed trials",
                        count(trials, concealed_detected, right_place), 0.90, false, true});
    measures.push_back(
        {"right_place_of_all_concealed", "the same of all concealed trials", count(trials, concealed, right_place)});
}

void add_names(const std::vector<ScoredTrial>& trials, std::vector<Measure>& measures) {
    const auto named = [](const ScoredTrial& t) { return in_catalogue(t) && one_set(t); };
    const auto detected = [](const ScoredTrial& t) { return in_catalogue(t) && claims(t); };
    const auto returned = [](const ScoredTrial& t) {
        return in_catalogue(t) && t.judgement.sets_returned > 0 && claims(t);
    };
    const auto right = [](const ScoredTrial& t) { return t.judgement.right_effect; };
    const auto among = [](const ScoredTrial& t) { return t.judgement.truth_returned; };
    const auto pair = [](const ScoredTrial& t) { return is_kind(t, TrialKind::pair); };
    const auto both = [](const ScoredTrial& t) { return t.judgement.right_names == 2; };
    const auto parameter = [](const ScoredTrial& t) { return is_kind(t, TrialKind::parameter_error); };
    measures.push_back({"right_effect",
                        "the named set is what is hidden, of trials inside the catalogue in which one set was named "
                        "(taken for separable)",
                        count(trials, named, right), 0.95, false, true});
    measures.push_back({"right_effect_of_detected", "the same of all detected trials inside the catalogue",
                        count(trials, detected, right)});
    measures.push_back({"truth_in_returned_set",
                        "what is hidden is among the sets returned, of trials inside the catalogue in which any was",
                        count(trials, returned, among), 0.99, false, true});
    measures.push_back({"pairs_both_named", "both named, of pairs", count(trials, pair, both), 0.80, false, true});
    measures.push_back({"pairs_one_named", "at least one named, of pairs",
                        count(trials, pair, [](const ScoredTrial& t) { return t.judgement.right_names > 0; })});
    measures.push_back(
        {"parameter_error_named", "the number named, of plain parameter errors", count(trials, parameter, right)});
}

void add_boundaries(const std::vector<ScoredTrial>& trials, std::vector<Measure>& measures) {
    const auto outside = [](const ScoredTrial& t) { return is_kind(t, TrialKind::outside); };
    const auto abstains = [](const ScoredTrial& t) {
        return t.judgement.claim == Claim::nothing || t.judgement.claim == Claim::no_name;
    };
    const auto unexplained = [](const ScoredTrial& t) { return t.judgement.claim == Claim::no_name; };
    const auto outside_unexplained = [&](const ScoredTrial& t) { return outside(t) && unexplained(t); };
    const auto only_physics = [](const ScoredTrial& t) {
        return t.judgement.missing && !is_kind(t, TrialKind::sensor);
    };
    const auto sensor = [](const ScoredTrial& t) { return is_kind(t, TrialKind::sensor); };
    measures.push_back({"outside_abstains", "nothing or a place only, of trials outside the catalogue",
                        count(trials, outside, abstains), 0.95, false, true});
    measures.push_back(
        {"outside_unexplained", "unexplained, of trials outside the catalogue", count(trials, outside, unexplained)});
    measures.push_back(
        {"outside_right_place", "the first place is right, of those", count(trials, outside_unexplained, right_place)});
    measures.push_back({"outside_confident_wrong_name",
                        "one set named with confidence, of trials outside the catalogue",
                        count(trials, outside, one_set), 0.02, true, true});
    measures.push_back(
        {"sensor_named_for_physics", "a sensor named, of trials without a sensor fault in which something is missing",
         count(trials, only_physics, [](const ScoredTrial& t) { return t.judgement.sensor_for_physics; }), 0.01, true,
         true});
    measures.push_back({"physics_named_for_sensor", "physics named, of trials with sensor faults only",
                        count(trials, sensor, [](const ScoredTrial& t) { return t.judgement.physics_for_sensor; }),
                        0.01, true, true});
}

void add_intervals(const std::vector<ScoredTrial>& trials, std::vector<Measure>& measures) {
    Proportion parameters, numbers;
    for (const ScoredTrial& trial : trials) {
        parameters.hits += trial.judgement.parameters.hits;
        parameters.of += trial.judgement.parameters.of;
        numbers.hits += trial.judgement.numbers.hits;
        numbers.of += trial.judgement.numbers.of;
    }
    measures.push_back(
        {"intervals_cover",
         "intervals of 90 % of named parameters that hold the truth, where the effect is right (0.88 to 0.92 wanted)",
         parameters, 0.90, false, true});
    measures.push_back({"number_intervals_cover",
                        "the same for the retuned numbers of the case, where the effect is right or nothing is missing",
                        numbers});
}

void add_baselines(const std::vector<ScoredTrial>& trials, std::vector<Measure>& measures) {
    const auto null = [](const ScoredTrial& t) { return !t.judgement.missing; };
    const auto missing = [](const ScoredTrial& t) { return t.judgement.missing; };
    const auto tuned = [](const ScoredTrial& t) { return t.judgement.baseline_retuning != "consistent"; };
    const auto bic = [](const ScoredTrial& t) { return t.judgement.baseline_bic != "consistent"; };
    measures.push_back({"baseline_retuning_nulls",
                        "retuning alone finds fault (0.3 dB or a number out of tolerance), of nulls",
                        count(trials, null, tuned)});
    measures.push_back(
        {"baseline_retuning_detected", "the same, of trials with something missing", count(trials, missing, tuned)});
    measures.push_back(
        {"baseline_bic_nulls", "BIC over the PSDs takes the best set, of nulls", count(trials, null, bic)});
    measures.push_back(
        {"baseline_bic_detected", "the same, of trials with something missing", count(trials, missing, bic)});
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return NAN;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) - (share > 0.0)];
}

void score_misfit(const std::vector<ScoredTrial>& trials, ProofScore& score) {
    double retuned = 0.0, after = 0.0;
    std::vector<double> shares;
    for (const ScoredTrial& trial : trials) {
        const Judgement& j = trial.judgement;
        if (!std::isfinite(j.misfit_retuned) || !std::isfinite(j.misfit_after) || j.misfit_retuned < kLeastMisfit)
            continue;
        retuned += j.misfit_retuned;
        after += j.misfit_after;
        shares.push_back(1.0 - j.misfit_after / j.misfit_retuned);
    }
    score.misfit_trials = shares.size();
    score.misfit_removed = shares.empty() ? NAN : 1.0 - after / retuned;
    score.misfit_removed_median = quantile(shares, 0.5);
}

}  // namespace

std::vector<ScoredTrial> judge_all(const std::vector<TrialTruth>& truths, const std::vector<TrialResult>& results) {
    assert(truths.size() == results.size());
    std::vector<ScoredTrial> trials;
    for (std::size_t i = 0; i < truths.size(); ++i)
        trials.push_back({&truths[i], &results[i], judge(truths[i], results[i])});
    return trials;
}

ProofScore score_of(const std::vector<ScoredTrial>& trials) {
    ProofScore score{.trials = trials.size()};
    std::vector<double> seconds;
    double sets = 0.0, with_sets = 0.0;
    for (const ScoredTrial& trial : trials) {
        const Judgement& j = trial.judgement;
        score.failed += j.claim == Claim::failed;
        ++score.kinds[kind_name(trial.truth->kind)];
        ++score.confusion[j.hidden][j.returned];
        if (j.claim != Claim::failed) seconds.push_back(trial.result->seconds_diagnosed);
        if (j.claim == Claim::failed || !in_catalogue(trial) || !claims(trial) || j.sets_returned == 0) continue;
        sets += static_cast<double>(j.sets_returned);
        with_sets += 1.0;
    }
    score.mean_set_size = with_sets > 0.0 ? sets / with_sets : NAN;
    add_nulls_and_places(trials, score.measures);
    add_names(trials, score.measures);
    add_boundaries(trials, score.measures);
    add_intervals(trials, score.measures);
    add_baselines(trials, score.measures);
    score_misfit(trials, score);
    score.seconds = {quantile(seconds, 0.5), quantile(seconds, 0.9), quantile(seconds, 1.0), seconds.size()};
    score.calibration = calibration_curve(trials);
    score.detectability = detectability_of(trials);
    return score;
}

}  // namespace railpem::app

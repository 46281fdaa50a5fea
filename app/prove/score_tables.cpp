#include "app/prove/score_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "app/fingerprint.hpp"
#include "app/prove/score_proof.hpp"
#include "app/tables/json_values.hpp"

namespace railpem::app {

namespace {

Json proportion_json(const Proportion& proportion) {
    const auto [low, high] = wilson_interval(proportion);
    return {{"value", or_null(proportion.value())},
            {"hits", proportion.hits},
            {"of", proportion.of},
            {"low", low},
            {"high", high}};
}

Json measure_json(const Measure& measure) {
    Json json = proportion_json(measure.proportion);
    json["says"] = measure.says;
    if (measure.has_goal) json["goal"] = Json{{measure.at_most ? "at_most" : "at_least", measure.goal}};
    return json;
}

Json confusion_json(const ProofScore& score) {
    std::set<std::string> columns;
    for (const auto& [hidden, row] : score.confusion)
        for (const auto& [returned, trials] : row) columns.insert(returned);
    Json rows = Json::array(), counts = Json::array();
    for (const auto& [hidden, row] : score.confusion) {
        Json line = Json::array();
        for (const std::string& column : columns) line.push_back(row.count(column) ? row.at(column) : 0);
        rows.push_back(hidden);
        counts.push_back(line);
    }
    return {{"hidden", rows}, {"returned", columns}, {"trials", counts}};
}

Json calibration_json(const ProofScore& score) {
    Json array = Json::array();
    for (const CalibrationBin& bin : score.calibration)
        array.push_back({{"low", bin.low},
                         {"high", bin.high},
                         {"mean_probability", or_null(bin.true_sets.of ? bin.mean_probability : NAN)},
                         {"true", proportion_json(bin.true_sets)}});
    return array;
}

Json detectability_json(const ProofScore& score) {
    Json array = Json::array();
    for (const Detectability& own : score.detectability)
        array.push_back({{"effect", own.effect},
                         {"parameter", own.parameter},
                         {"weak_when_large", own.weak_when_large},
                         {"detected", proportion_json(own.detected)},
                         {"named", proportion_json(own.named)},
                         {"smallest_detected", or_null(own.smallest_detected)},
                         {"largest_missed", or_null(own.largest_missed)},
                         {"threshold", or_null(own.threshold)}});
    return array;
}

std::vector<std::string> hidden_labels(const TrialTruth& truth) {
    std::vector<std::string> labels;
    for (const simulate::Hidden& hidden : truth.hidden) labels.push_back(label_of(hidden));
    return labels;
}

std::vector<std::string> named_labels(const TrialResult& result) {
    std::vector<std::string> labels;
    for (const ClaimedEffect& claimed : result.omitted) labels.push_back(label_of(claimed));
    return labels;
}

std::vector<std::string> rival_labels(const TrialResult& result) {
    std::vector<std::string> sets;
    for (const ClaimedSet& set : result.rivals) {
        std::string text;
        for (const ClaimedEffect& claimed : set.effects) text += (text.empty() ? "" : " + ") + label_of(claimed);
        sets.push_back(text);
    }
    return sets;
}

Json wrong_json(const std::vector<ScoredTrial>& trials) {
    Json array = Json::array();
    for (const ScoredTrial& trial : trials) {
        if (trial.judgement.wrong.empty()) continue;
        const TrialResult& result = *trial.result;
        Json seeds = Json::array(), hidden = Json::array();
        for (const TrialRecord& record : trial.truth->records) seeds.push_back(record.seed);
        for (const simulate::Hidden& own : trial.truth->hidden)
            hidden.push_back(Json::parse(simulate::hidden_json(own)));
        array.push_back({{"trial", result.trial},
                         {"seeds", seeds},
                         {"wrong", trial.judgement.wrong},
                         {"kind", kind_name(trial.truth->kind)},
                         {"hidden", hidden},
                         {"verdict", result.verdict},
                         {"named", named_labels(result)},
                         {"rivals", rival_labels(result)},
                         {"place", result.places.empty() ? "" : result.places.front().first},
                         {"records", trial.truth->records.size()},
                         {"retuned_rms_db", or_null(result.retuned.rms_db)},
                         {"hidden_by_retuning", or_null(result.hidden_by_retuning)},
                         {"retuned_outside", result.retuned_outside},
                         {"failure", result.failure}});
    }
    return array;
}

Json wrong_counts(const std::vector<ScoredTrial>& trials) {
    std::map<std::string, std::size_t> counts;
    for (const ScoredTrial& trial : trials)
        if (!trial.judgement.wrong.empty()) ++counts[trial.judgement.wrong];
    return counts;
}

Json programs_json(const std::vector<ScoredTrial>& trials) {
    std::map<std::string, std::size_t> programs;
    for (const ScoredTrial& trial : trials) ++programs[trial.result->program];
    return programs;
}

/// Everything counted once more for the trials of each world by themselves.
Json worlds_json(const std::vector<ScoredTrial>& trials) {
    std::map<std::string, std::vector<ScoredTrial>> worlds;
    for (const ScoredTrial& trial : trials) worlds[trial.truth->world.name()].push_back(trial);
    Json json = Json::object();
    for (const auto& [name, own] : worlds) {
        const ProofScore score = score_of(own);
        Json measures = Json::object();
        for (const Measure& measure : score.measures) measures[measure.name] = proportion_json(measure.proportion);
        json[name] = {{"finished", score.trials}, {"failed", score.failed}, {"measures", measures}};
    }
    return json;
}

std::string truths_fingerprint(const std::vector<ScoredTrial>& trials) {
    std::string all;
    for (const ScoredTrial& trial : trials) all += trial_truth_text(*trial.truth);
    return fingerprint_text(all);
}

std::string joined_with(const std::vector<std::string>& items, const char* separator) {
    std::string text;
    for (const std::string& item : items) text += (text.empty() ? "" : separator) + item;
    return text;
}

/// Quoted where a comma or a quote would break the row.
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : c == '\n' ? std::string(" ") : std::string(1, c);
    return quoted + "\"";
}

std::string cell(double value) {
    return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}
std::string cell(bool value) {
    return value ? "1" : "0";
}
std::string cell(std::size_t value) {
    return std::to_string(value);
}

template <typename... Cells>
std::string row(const Cells&... cells) {
    std::string text;
    ((text += cell(cells) + ","), ...);
    text.back() = '\n';
    return text;
}

std::string row_of(const ScoredTrial& trial) {
    const TrialTruth& truth = *trial.truth;
    const TrialResult& result = *trial.result;
    const Judgement& j = trial.judgement;
    std::vector<std::string> speeds;
    for (const TrialRecord& record : truth.records) speeds.push_back(fmt::format("{:.2f}", record.speed_m_per_s));
    return row(result.trial, truth.world.name(), kind_name(truth.kind), joined_with(hidden_labels(truth), " + "),
               joined_with(true_places(truth), " + "), true_strength(truth), joined_with(speeds, " "),
               result.failure.empty() ? result.verdict : "failed", joined_with(named_labels(result), " + "),
               joined_with(rival_labels(result), " | "),
               result.places.empty() ? std::string() : result.places.front().first,
               result.places.empty() ? NAN : result.places.front().second, result.before.rms_db, result.retuned.rms_db,
               result.after.rms_db, result.held_out_before.log_likelihood_per_second,
               result.held_out_retuned.log_likelihood_per_second, result.held_out_after.log_likelihood_per_second,
               result.hidden_by_retuning, j.missing, j.concealed, j.right_place, j.right_effect, j.truth_returned,
               j.sets_returned, j.baseline_retuning, j.baseline_bic, result.bic_gain, result.seconds_simulated,
               result.seconds_diagnosed, j.wrong);
}

}  // namespace

std::string trials_csv(const std::vector<ScoredTrial>& trials) {
    std::string text =
        "trial,world,kind,hidden,places,strength,speeds_m_per_s,verdict,named,rivals,first_place,first_place_"
        "probability,"
        "before_rms_db,retuned_rms_db,after_rms_db,"
        "held_out_before_nats_per_s,held_out_retuned_nats_per_s,held_out_after_nats_per_s,hidden_by_retuning,missing,"
        "concealed,right_place,right_effect,"
        "truth_returned,sets_returned,baseline_retuning,baseline_bic,bic_gain,seconds_simulated,seconds_diagnosed,"
        "wrong\n";
    for (const ScoredTrial& trial : trials) text += row_of(trial);
    return text;
}

std::string score_json(const ProofScore& score, const std::vector<ScoredTrial>& trials, const std::string& settings,
                       std::size_t asked) {
    Json measures = Json::object();
    for (const Measure& measure : score.measures) measures[measure.name] = measure_json(measure);
    const Json json{{"trials", asked},
                    {"finished", score.trials},
                    {"failed", score.failed},
                    {"worlds", worlds_json(trials)},
                    {"kinds", score.kinds},
                    {"measures", measures},
                    {"mean_set_size", {{"value", or_null(score.mean_set_size)}, {"goal", {{"at_most", 1.3}}}}},
                    {"held_out_misfit_removed",
                     {{"value", or_null(score.misfit_removed)},
                      {"median", or_null(score.misfit_removed_median)},
                      {"trials", score.misfit_trials},
                      {"goal", {{"at_least", 0.95}}}}},
                    {"seconds_per_diagnosis",
                     {{"median", or_null(score.seconds.median)},
                      {"ninetieth", or_null(score.seconds.ninetieth)},
                      {"largest", or_null(score.seconds.largest)},
                      {"goal", {{"at_most", 60.0}}}}},
                    {"interval", "Wilson, 95 %"},
                    {"wrong_counts", wrong_counts(trials)},
                    {"confusion", confusion_json(score)},
                    {"calibration", calibration_json(score)},
                    {"detectability", detectability_json(score)},
                    {"wrong", wrong_json(trials)},
                    {"not_scored",
                     {"held-out misfit removed by the best wrong physics: what competes with the right set is fitted "
                      "only as far as it could win; tests/benchmark/wrong_physics.cpp fits it to its end",
                      "controls with wrong physics of equal freedom, decoys and shuffled channels"}},
                    {"settings", Json::parse(settings)},
                    {"settings_fingerprint", fingerprint_text(settings)},
                    {"truths_fingerprint", truths_fingerprint(trials)},
                    {"programs", programs_json(trials)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string score_lines(const ProofScore& score) {
    std::string text;
    for (const Measure& measure : score.measures) {
        if (measure.proportion.of == 0) continue;
        const auto [low, high] = wilson_interval(measure.proportion);
        const std::string goal =
            measure.has_goal ? fmt::format("  goal {} {:.0f} %", measure.at_most ? "<=" : ">=", 100.0 * measure.goal)
                             : "";
        text += fmt::format("{:<32} {:>4}/{:<4} {:5.1f} % [{:.1f}, {:.1f}]{}\n", measure.name, measure.proportion.hits,
                            measure.proportion.of, 100.0 * measure.proportion.value(), 100.0 * low, 100.0 * high, goal);
    }
    text += fmt::format("{:<32} {:.2f}\n{:<32} {:.1f} % of {} trials\n{:<32} median {:.0f} s, ninetieth {:.0f} s\n",
                        "mean_set_size", score.mean_set_size, "held_out_misfit_removed", 100.0 * score.misfit_removed,
                        score.misfit_trials, "seconds_per_diagnosis", score.seconds.median, score.seconds.ninetieth);
    return text;
}

}  // namespace railpem::app

// Made-up trials whose score is counted by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/prove/score_proof.hpp"
#include "app/prove/score_tables.hpp"
#include "tests/unit/prove/proof_case.hpp"

namespace railpem::app {
namespace {

TrialTruth truth_of(std::size_t trial, TrialKind kind, const std::vector<std::string>& hidden) {
    TrialTruth truth{
        .trial = trial, .kind = kind, .records = {{.speed_m_per_s = 20.0, .stated_speed_m_per_s = 20.0, .seed = 7}}};
    for (const std::string& text : hidden) truth.hidden.push_back(simulate::parse_hidden(text));
    truth.numbers = {{.key = "vehicle.body_mass_kg", .believed = 100.0, .truth = 104.0}};
    return truth;
}

TrialResult result_of(std::size_t trial, const std::string& verdict, const std::vector<ClaimedEffect>& omitted,
                      const std::string& place, double retuned_db = 1.0) {
    TrialResult result{.trial = trial, .verdict = verdict, .omitted = omitted};
    if (!place.empty()) result.places = {{place, 0.9}};
    result.retuned.rms_db = retuned_db;
    result.numbers = {{"vehicle.body_mass_kg", 102.0, 99.0, 105.0}};
    result.seconds_diagnosed = static_cast<double>(trial);
    return result;
}

const Measure& measure(const ProofScore& score, const std::string& name) {
    for (const Measure& own : score.measures)
        if (own.name == name) return own;
    throw std::runtime_error("no measure " + name);
}

void expect_counts(const ProofScore& score, const std::string& name, std::size_t hits, std::size_t of) {
    EXPECT_EQ(measure(score, name).proportion.hits, hits) << name;
    EXPECT_EQ(measure(score, name).proportion.of, of) << name;
}

ClaimedEffect exponent(double low, double high) {
    return {"pad-frequency-stiffening", {}, "pad", 0.9, {{"exponent", 0.5 * (low + high), low, high, "1"}}};
}

/// Ten trials: what is hidden and what was said.
struct Made {
    std::vector<TrialTruth> truths;
    std::vector<TrialResult> results;
    Made() {
        const ClaimedEffect gain{
            "sensor-gain", {{"channel", "bogie_1"}}, "sensor", 0.9, {{"gain", 1.1, 1.0, 1.2, "1"}}};
        const ClaimedEffect shear{"rail-shear", {}, "rail", 0.9, {}};
        const std::string stiffening = "pad-frequency-stiffening:exponent=0.1";
        add(TrialKind::nothing, {}, "consistent", {}, "");
        add(TrialKind::nothing, {}, "explained", {shear}, "rail");
        // right, concealed, covered
        add(TrialKind::single, {stiffening}, "explained", {exponent(0.08, 0.12)}, "pad", 0.2);
        // right, not covered
        add(TrialKind::single, {"pad-frequency-stiffening:exponent=0.3"}, "explained", {exponent(0.1, 0.2)}, "pad");
        // missed, concealed
        add(TrialKind::single, {"pad-frequency-stiffening:exponent=0.03"}, "consistent", {}, "", 0.1);
        add(TrialKind::single, {"rail-shear"}, "explained", {gain}, "sensor");  // sensor for physics
        add(TrialKind::pair, {stiffening, "rail-shear"}, "explained", {shear, exponent(0.05, 0.15)}, "rail");
        add(TrialKind::sensor, {"sensor-gain:channel=bogie_1,gain=1.3"}, "recording-fault", {gain}, "sensor");
        // another channel
        add(TrialKind::sensor, {"sensor-gain:channel=bogie_2,gain=1.3"}, "recording-fault", {gain}, "sensor");
        add(TrialKind::outside, {"bogie-coupling"}, "unexplained", {}, "bogie");
        add(TrialKind::outside, {"bogie-coupling"}, "explained", {shear}, "rail");
        add(TrialKind::single, {"rail-shear"}, "ambiguous", {}, "rail");
        results.back().rivals = {{{shear}, 0.6}, {{exponent(0.0, 1.0)}, 0.4}, {{shear}, 0.1}};
    }
    void add(TrialKind kind, const std::vector<std::string>& hidden, const std::string& verdict,
             const std::vector<ClaimedEffect>& omitted, const std::string& place, double retuned_db = 1.0) {
        truths.push_back(truth_of(truths.size(), kind, hidden));
        results.push_back(result_of(results.size(), verdict, omitted, place, retuned_db));
    }
};

TEST(ProofScore, CountsAsByHand) {
    const Made made;
    const std::vector<ScoredTrial> trials = judge_all(made.truths, made.results);
    const ProofScore score = score_of(trials);
    expect_counts(score, "nulls_named", 1, 2);
    expect_counts(score, "detected", 9, 10);
    expect_counts(score, "right_place", 7, 9);  // wrong: the sensor for the rail, and the rail for the bogie
    expect_counts(score, "right_place_of_all", 7, 10);
    expect_counts(score, "right_place_concealed", 1, 1);
    expect_counts(score, "right_place_of_all_concealed", 1, 2);
    expect_counts(score, "right_effect", 4, 6);  // wrong: the sensor for the rail, and the other channel
    expect_counts(score, "right_effect_of_detected", 4, 7);
    expect_counts(score, "truth_in_returned_set", 5, 7);
    expect_counts(score, "pairs_both_named", 1, 1);
    expect_counts(score, "outside_abstains", 1, 2);
    expect_counts(score, "outside_confident_wrong_name", 1, 2);
    expect_counts(score, "sensor_named_for_physics", 1, 8);
    expect_counts(score, "physics_named_for_sensor", 0, 2);
    // exponents 0.1 of trial 2 and of the pair; not 0.3, not the gain 1.3 over 1.2
    expect_counts(score, "intervals_cover", 2, 4);
    expect_counts(score, "number_intervals_cover", 5, 5);  // four right ones and the null
    EXPECT_NEAR(score.mean_set_size, 8.0 / 7.0, 1e-12);    // the ambiguous one returns two
    EXPECT_EQ(score.confusion.at("pad-frequency-stiffening").at("pad-frequency-stiffening"), 2u);
    EXPECT_EQ(score.confusion.at("pad-frequency-stiffening").at("nothing"), 1u);
    EXPECT_EQ(score.confusion.at("pair").at("several"), 1u);
    EXPECT_EQ(score.seconds.median, 5.0);
    EXPECT_EQ(score.seconds.largest, 11.0);
}

TEST(ProofScore, SaysWhatIsWrong) {
    const Made made;
    const std::vector<std::string> expected{"",
                                            "named although nothing is missing",
                                            "",
                                            "",
                                            "missed",
                                            "sensor named for physics",
                                            "",
                                            "",
                                            "wrong effect",
                                            "",
                                            "confident name for what the catalogue does not have",
                                            ""};
    const std::vector<ScoredTrial> trials = judge_all(made.truths, made.results);
    for (std::size_t i = 0; i < trials.size(); ++i) EXPECT_EQ(trials[i].judgement.wrong, expected[i]) << i;
}

TEST(ProofScore, MisfitRemovedIsPooledOverRightNames) {
    Made made;
    made.results[2].held_out_retuned.log_likelihood_per_second = -4.0;
    made.results[2].held_out_after.log_likelihood_per_second = -0.1;
    made.results[3].held_out_retuned.log_likelihood_per_second = -1.0;
    made.results[3].held_out_after.log_likelihood_per_second = -0.4;
    made.results[5].held_out_retuned.log_likelihood_per_second = -50.0;  // a wrong name does not count
    const ProofScore score = score_of(judge_all(made.truths, made.results));
    EXPECT_EQ(score.misfit_trials, 2u);
    EXPECT_NEAR(score.misfit_removed, 1.0 - 0.5 / 5.0, 1e-12);
}

TEST(ProofScore, FailedTrialsAreCountedAndNothingElse) {
    Made made;
    made.results[2].failure = "diagnosis: no";
    const ProofScore score = score_of(judge_all(made.truths, made.results));
    EXPECT_EQ(score.failed, 1u);
    expect_counts(score, "detected", 8, 9);
}

TEST(ProofScore, DetectabilityFindsTheEdge) {
    const Made made;
    const ProofScore score = score_of(judge_all(made.truths, made.results));
    for (const Detectability& own : score.detectability) {
        if (own.effect != "pad-frequency-stiffening") continue;
        EXPECT_EQ(own.detected.of, 3u);
        EXPECT_EQ(own.detected.hits, 2u);
        EXPECT_DOUBLE_EQ(own.largest_missed, 0.03);
        EXPECT_DOUBLE_EQ(own.smallest_detected, 0.1);
        EXPECT_DOUBLE_EQ(own.threshold, 0.1);
        return;
    }
    FAIL() << "no detectability of the pad";
}

TEST(ProofScore, CalibrationHoldsSetsAgainstTheTruth) {
    Made made;
    made.results[2].posterior = {{{"pad-frequency-stiffening"}, 0.97}, {{}, 0.03}};
    made.results[9].posterior = {{{"unknown"}, 0.96}, {{"rail-shear"}, 0.04}};
    made.results[0].posterior = {{{"rail-shear"}, 0.97}, {{}, 0.03}};
    const ProofScore score = score_of(judge_all(made.truths, made.results));
    for (const CalibrationBin& bin : score.calibration) {
        if (bin.low == 0.95) {
            EXPECT_EQ(bin.true_sets.hits, 2u);
            EXPECT_EQ(bin.true_sets.of, 3u);
            EXPECT_NEAR(bin.mean_probability, 2.9 / 3.0, 1e-12);
        }
        if (bin.low == 0.01) {  // {} of trial 2 is wrong and of trial 0 right, {rail-shear} of trial 9 wrong
            EXPECT_EQ(bin.true_sets.hits, 1u);
            EXPECT_EQ(bin.true_sets.of, 3u);
        }
    }
}

TEST(ScoreTables, AreWhatTheyPromise) {
    const Made made;
    const std::vector<ScoredTrial> trials = judge_all(made.truths, made.results);
    const std::string csv = trials_csv(trials);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), static_cast<long>(trials.size()) + 1);
    const auto json = nlohmann::json::parse(score_json(score_of(trials), trials, "{\"seed\": 1}", 20));
    EXPECT_EQ(json.at("trials"), 20);
    EXPECT_EQ(json.at("finished"), trials.size());
    EXPECT_EQ(json.at("wrong").size(), 5u);
    EXPECT_EQ(json.at("wrong").at(1).at("trial"), 4);
    EXPECT_EQ(json.at("measures").at("nulls_named").at("goal").at("at_most"), 0.01);
}

TEST(ScoreTables, CountEveryWorldByItself) {
    Made made;
    for (std::size_t i = 0; i < 2; ++i) made.truths[i].world = read_world_option("worn");
    const std::vector<ScoredTrial> trials = judge_all(made.truths, made.results);
    const std::string csv = trials_csv(trials);
    EXPECT_EQ(csv.substr(0, 17), "trial,world,kind,");
    EXPECT_NE(csv.find("\n0,worn,nothing,"), std::string::npos);
    EXPECT_NE(csv.find("\n2,ideal,single,"), std::string::npos);
    const auto json = nlohmann::json::parse(score_json(score_of(trials), trials, "{}", 20));
    EXPECT_EQ(json.at("worlds").at("worn").at("finished"), 2u);
    EXPECT_EQ(json.at("worlds").at("ideal").at("finished"), trials.size() - 2);
    const auto& nulls = json.at("worlds").at("worn").at("measures").at("nulls_named");
    EXPECT_EQ(nulls.at("hits"), 1u) << "of the two nulls one was named";
    EXPECT_EQ(nulls.at("of"), 2u);
}

TEST(TrialResult, IsReadBackAsItWasWritten) {
    TrialResult result = result_of(3, "explained", {exponent(0.1, 0.2)}, "pad");
    result.omitted.front().choices = {{"channel", "bogie_1"}};
    result.rivals = {{{exponent(0.1, 0.3)}, 0.25}};
    result.posterior = {{{"unknown"}, 0.5}};
    result.held_out_after = {0.25, std::nan("")};
    result.retuned_outside = {"contact.constant_m_per_n23"};
    result.program = "abc";
    const std::string text = trial_result_text(result, "{}");
    EXPECT_EQ(trial_result_text(read_trial_result("x", text), "{}"), text);
}

// What retuning conceals is asked of every trial alike, whatever its verdict is held against.
TEST(TrialResult, RetunedIsWhatMayLeaveItsBeliefs) {
    diagnosis::Diagnosis diagnosis;
    diagnosis.omitted = {{.instance = {.effect = "parameter-error"}, .parameters = {{"factor", 1.5, 1.4, 1.6, "1"}}}};
    diagnosis.recordings = {{.name = "run", .averages = 20.0}};
    diagnosis.channels = {{.recording = "run",
                           .channel = "wheel_1",
                           .measured = {1.0, 1.0},
                           .retuned = {0.5, 0.5},
                           .diagnosed = {1.0, 1.0}}};
    diagnosis.retuned = {2.9, -350.0}, diagnosis.held_out_retuned = {3.1, -20.0};
    const TrialResult kept = trial_result(1, diagnosis);
    EXPECT_EQ(kept.retuned.rms_db, 2.9);
    EXPECT_GT(kept.bic_gain, 0.0);

    diagnosis.freely_retuned = diagnosis::FreelyRetuned{.fitted = {0.4, -318.0}, .held_out = {0.9, 11.0}};
    const TrialResult result = trial_result(1, diagnosis);
    EXPECT_EQ(result.retuned.rms_db, 0.4);
    EXPECT_EQ(result.held_out_retuned.log_likelihood_per_second, 11.0);
    EXPECT_LT(result.bic_gain, 0.0) << "its parameter, for nothing";
}

// Newcombe, Statistics in Medicine 17 (1998) 857, table I, method 3.
TEST(WilsonInterval, IsThatOfThePublishedTable) {
    const auto expect = [](std::size_t hits, std::size_t of, double low, double high) {
        const auto [from, to] = wilson_interval({hits, of});
        EXPECT_NEAR(from, low, 5e-5);
        EXPECT_NEAR(to, high, 5e-5);
    };
    expect(81, 263, 0.2553, 0.3662);
    expect(15, 148, 0.0624, 0.1605);
    expect(0, 20, 0.0, 0.1611);
    expect(1, 29, 0.0061, 0.1718);
}

}  // namespace
}  // namespace railpem::app

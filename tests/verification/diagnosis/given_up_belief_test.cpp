// What a verdict is held against that only gives up a belief.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/diagnose.hpp"
#include "diagnosis/effects/effect.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr double kHeldOut_s = 15.0;  // a quarter of a minute

/// One number is wrong by a factor, and nothing else can be named.
Diagnosis with_a_wrong_number(double tolerance, double factor) {
    const std::string key = "vehicle.primary.stiffness_n_per_m";
    DiagnoseOptions options{.threads = 2};
    for (const Effect& effect : effects())
        if (effect.id != "parameter-error") options.naming.without.push_back(effect.id);
    Synthesised made = synthesised(paper_believed({key, "vehicle.primary.damping_n_s_per_m"}), {20.0}, 60.0,
                                   {"bogie_1", "wheel_1"}, kSmall);
    made.believed.uncertain.front().tolerance = tolerance;
    number_at(made.truth.numbers, key) *= factor;
    made.draw(7);
    return diagnose(made.believed, made.observations, options);
}

TEST(GivenUpBelief, IsHeldAgainstTheCaseThatKeepsIt) {
    const Diagnosis found = with_a_wrong_number(0.1, 1.6);
    ASSERT_EQ(found.verdict, Verdict::explained) << found.statement;
    ASSERT_TRUE(found.freely_retuned.has_value());
    EXPECT_LT(std::abs(found.held_out_after.log_likelihood_per_second -
                       found.freely_retuned->held_out.log_likelihood_per_second),
              2.0 / kHeldOut_s)
        << "retuning went there, too";
    const double gain = kHeldOut_s * (found.held_out_after.log_likelihood_per_second -
                                      found.held_out_retuned.log_likelihood_per_second);
    EXPECT_GT(gain, 10.0);
    EXPECT_NEAR(found.omitted.front().nats_held_out, gain, 1e-6 * gain) << "the table says what the sentence says";
    EXPECT_GT(found.hidden_by_retuning, 0.99) << "calibration finds the value and hides that the belief was wrong";
    EXPECT_TRUE(found.retuned_numbers.front().outside);
    EXPECT_TRUE(found.numbers.front().outside);
    EXPECT_FALSE(found.mismatch.empty()) << "bands that keep the belief from being right";
    const bool worse = std::any_of(found.channels.begin(), found.channels.end(), [](const ChannelComparison& own) {
        double retuned = 0.0, diagnosed = 0.0;
        for (const double db : own.band_retuned_db) retuned += db * db;
        for (const double db : own.band_diagnosed_db) diagnosed += db * db;
        return retuned > 2.0 * diagnosed;
    });
    EXPECT_TRUE(worse) << "curves are of the case that keeps the belief";
}

// A number so well known that retuning does not follow: retuning is the rival.
TEST(GivenUpBelief, IsHeldAgainstRetuningThatKeepsItAnyhow) {
    const Diagnosis found = with_a_wrong_number(0.003, 1.3);
    ASSERT_EQ(found.verdict, Verdict::explained) << found.statement;
    EXPECT_FALSE(found.freely_retuned.has_value());
    EXPECT_GT(found.held_out_after.log_likelihood_per_second, found.held_out_retuned.log_likelihood_per_second);
}

TEST(GivenUpBelief, WithinTwoTolerancesIsNone) {
    const Diagnosis found = with_a_wrong_number(0.1, 1.15);
    EXPECT_EQ(found.verdict, Verdict::consistent) << found.statement;
    EXPECT_FALSE(found.freely_retuned.has_value());
}

}  // namespace
}  // namespace railpem::diagnosis

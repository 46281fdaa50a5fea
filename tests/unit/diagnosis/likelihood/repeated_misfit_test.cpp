// Misfit that the unseen part repeats: nothing under the truth, and what the likelihood loses under something else.

#include "diagnosis/likelihood/repeated_misfit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr int kMisfitDraws = 24;

Synthesised two_speeds() {
    return synthesised(paper_believed({"vehicle.primary.damping_n_s_per_m"}), {15.0, 80.0 / 3.6}, 60.0,
                       {"body", "bogie_1", "wheel_1"}, kSmall);
}

TEST(RepeatedMisfit, IsNothingUnderTheTruth) {
    Synthesised made = two_speeds();
    double sum = 0.0, squares = 0.0;
    for (int seed = 0; seed < kMisfitDraws; ++seed) {
        made.draw(static_cast<std::uint64_t>(seed));
        const RepeatedMisfit misfit = repeated_misfit(made.truth, predict(made.truth, made.context()), made.context());
        const double own = misfit.nats / misfit.deviation;
        sum += own;
        squares += own * own;
    }
    // of the mean of so many standard deviates
    EXPECT_LT(std::abs(sum) / kMisfitDraws, 3.0 / std::sqrt(kMisfitDraws));
    // the deviation is no smaller than the scatter
    EXPECT_LT(squares / kMisfitDraws, 1.0 + 3.0 * std::sqrt(2.0 / kMisfitDraws));
    EXPECT_GT(squares / kMisfitDraws, 0.3);  // and not more than twice as large
}

TEST(RepeatedMisfit, IsWhatTheLikelihoodLoses) {
    Synthesised made = two_speeds();
    Trial wrong = made.truth;
    number_at(wrong.numbers, "vehicle.primary.damping_n_s_per_m") *= 1.15;
    double repeated = 0.0, lost = 0.0, deviation = 0.0;
    for (int seed = 0; seed < kMisfitDraws; ++seed) {
        made.draw(static_cast<std::uint64_t>(seed));
        const LikelihoodContext all = made.context(Part::all);
        const Predictions expected = predict(made.truth, all), other = predict(wrong, all);
        const RepeatedMisfit misfit = repeated_misfit(wrong, other, all);
        repeated += misfit.nats / kMisfitDraws;
        deviation = misfit.deviation;
        lost += (log_likelihood(made.truth, expected, all) - log_likelihood(wrong, other, all)) / kMisfitDraws;
    }
    EXPECT_GT(lost, 3.0 * deviation);
    // ½n·tr(Δ²) is the loss to second order in Δ, here some 15 % of the power of a channel: a third order is left.
    EXPECT_NEAR(repeated, lost, 0.25 * lost + 3.0 * deviation / std::sqrt(kMisfitDraws));
}

}  // namespace
}  // namespace railpem::diagnosis

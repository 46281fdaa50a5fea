// Levels that are off in both parts of a recording: those that are, and not what chance makes of either.

#include "diagnosis/judge/repeated_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/judge/compare_channels.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr int kLevelDraws = 24;

Synthesised short_run() {
    return synthesised(paper_believed({"vehicle.primary.damping_n_s_per_m"}), {80.0 / 3.6}, 30.0,
                       {"body", "bogie_1", "wheel_1"}, kSmall);
}

/// The truth, all of it too low by so many dB.
Fit too_low(const Synthesised& made, double by_db) {
    Fit fit{.trial = made.truth, .predictions = predict(made.truth, made.context())};
    for (ExpectedSpectra& own : fit.predictions.spectra)
        for (std::complex<double>& value : own.values) value *= std::pow(10.0, -0.1 * by_db);
    return fit;
}

double rms_of(const Fit& fit, const Synthesised& made, Part part) {
    const Stages same{&fit.trial, &fit.predictions, &fit.trial, &fit.predictions, &fit.trial, &fit.predictions};
    return rms_db(compare_channels(same, made.observations, part), Stage::diagnosed);
}

/// Mean square of what is repeated, and of both parts.
struct Squares {
    double repeated = 0.0, parts = 0.0;
};

Squares of_draws(double by_db) {
    Synthesised made = short_run();
    Squares mean;
    for (int seed = 0; seed < kLevelDraws; ++seed) {
        made.draw(static_cast<std::uint64_t>(seed));
        const Fit fit = too_low(made, by_db);
        mean.repeated += std::pow(repeated_level_db(fit, made.context(Part::fitted, 1)), 2) / kLevelDraws;
        mean.parts += rms_of(fit, made, Part::fitted) * rms_of(fit, made, Part::held_out) / kLevelDraws;
    }
    return mean;
}

/// of both parts' own errors: bands of a draw are few and err together, and what is below zero counts as zero
constexpr double kLeftOfChance = 0.25;

// Half a minute leaves more to chance than 0.7 dB in either part.
TEST(RepeatedLevels, AreNotThoseOfChance) {
    const Squares truth = of_draws(0.0);
    EXPECT_GT(truth.parts, 0.5);
    EXPECT_LT(truth.repeated, kLeftOfChance * truth.parts);
}

// (2 + e₁)(2 + e₂) + (2 − e₁)(2 − e₂) = 8 + 2e₁e₂: of levels as much too low as too high nothing is left but what
// chance leaves at the truth.
TEST(RepeatedLevels, AreThoseThatAreOff) {
    const Squares low = of_draws(2.0), high = of_draws(-2.0);
    EXPECT_NEAR(0.5 * (low.repeated + high.repeated), 4.0, kLeftOfChance * of_draws(0.0).parts);
}

TEST(RepeatedLevels, AreNoneWithoutTimeSeries) {
    const std::vector<Observation> none;
    EXPECT_EQ(repeated_level_db({}, {.observations = &none}), 0.0);
}

}  // namespace
}  // namespace railpem::diagnosis

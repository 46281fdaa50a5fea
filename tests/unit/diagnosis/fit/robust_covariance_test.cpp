// How much wider the numbers' deviations are than those of an exact model, on recordings drawn from the case itself and
// from another.

#include "diagnosis/fit/robust_covariance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

const std::vector<std::string> kNumbers = {"vehicle.body_mass_kg", "vehicle.bogie_mass_kg",
                                           "vehicle.secondary.stiffness_n_per_m", "vehicle.secondary.damping_n_s_per_m",
                                           "vehicle.primary.stiffness_n_per_m"};

Synthesised three_speeds() {
    return synthesised(paper_believed(kNumbers), {15.0, 22.2, 33.0}, 60.0,
                       {"body_front", "body_rear", "bogie_1", "wheel_1", "wheel_2"},
                       {.window_s = 2.0, .low_hz = 2.0, .high_hz = 60.0});
}

/// Deviations of the numbers as multiples of those of an exact model.
std::vector<double> widening(const Synthesised& made) {
    const std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    const Fit own = fit(believed_trial(made.believed, made.observations), unknowns, means(unknowns), made.context());
    const Eigen::MatrixXd robust = robust_covariance(own, made.context());
    std::vector<double> ratios;
    for (const std::string& number : kNumbers) {
        std::size_t u = 0;
        EXPECT_NE(own.find(number, &u), nullptr);
        ratios.push_back(std::sqrt(robust(static_cast<long>(u), static_cast<long>(u))) / own.deviation(u));
        std::printf("%.2f ", ratios.back());
    }
    std::printf("\n");
    return ratios;
}

// 3 × 15 third octaves know the scatter's deviation to a tenth (√(1/2·45)); of ratios that are that far off and never
// below 1 the mean is 1.04, and 1.2 is four deviations of the mean of fifteen, were they independent.
TEST(RobustCovariance, IsThatOfTheFitWhereTheModelIsRight) {
    double sum = 0.0;
    for (const std::uint64_t seed : {1, 2, 3}) {
        Synthesised made = three_speeds();
        made.draw(seed);
        for (const double ratio : widening(made)) {
            EXPECT_GE(ratio, 1.0);
            sum += ratio;
        }
    }
    EXPECT_LT(sum / 15.0, 1.2);
}

// A body that bends: bands beside the mode pull its mass and the springs under it to other values than the rest.
TEST(RobustCovariance, IsWiderWhereBandsDisagree) {
    Synthesised made = three_speeds();
    made.truth.effects.push_back(
        {.effect = "body-bending",
         .values = {{"frequency_hz", 9.5}, {"damping_ratio", 0.02}, {"modal_mass_kg", 8e3}, {"shape_at_pivots", -0.3}},
         .choices = {}});
    made.draw(4);
    EXPECT_GT(widening(made)[2], 2.0);
}

// The strength is known to some thousandths where the law is exact; what marched records say of the law is added.
TEST(RobustCovariance, KnowsWhatALawGetsWrong) {
    Synthesised made = three_speeds();
    const EffectInstance preload{.effect = "pad-preload-stiffening", .values = {{"strength", 0.8}}, .choices = {}};
    made.truth.effects.push_back(preload);
    made.draw(5);
    Trial trial = believed_trial(made.believed, made.observations);
    trial.effects.push_back(preload);
    std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    std::vector<double> start = means(unknowns);
    for (const Unknown& unknown : effect_unknowns(preload, 0)) unknowns.push_back(unknown), start.push_back(0.8);
    const Fit own = fit(trial, unknowns, start, made.context());
    const long u = static_cast<long>(unknowns.size()) - 1;
    const double strength = own.values.back(),
                 law = find_effect("pad-preload-stiffening")->parameters.front().inexact * strength;
    const double deviation = std::sqrt(robust_covariance(own, made.context())(u, u));
    EXPECT_GE(deviation, std::hypot(own.deviation(static_cast<std::size_t>(u)), law) * (1.0 - 1e-9));
    // bands disagree by chance only
    EXPECT_LE(deviation, std::hypot(2.0 * own.deviation(static_cast<std::size_t>(u)), law));
}

}  // namespace
}  // namespace railpem::diagnosis

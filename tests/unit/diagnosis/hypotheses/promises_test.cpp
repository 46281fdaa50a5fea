// First-order promises against the evidences of a Gaussian problem computed by brute force: sums over a grid of the
// unknowns.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>

#include "diagnosis/hypotheses/corrections.hpp"
#include "diagnosis/hypotheses/screen.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

/// Log of ∫ exp(−½(x − a)²F + …) N(x; mean, deviation) dx by the trapezium rule.
double log_evidence(double best, double information, double mean, double deviation) {
    constexpr int kPoints = 200001;
    const double reach = 12.0 * deviation + 12.0 / std::sqrt(information) + std::abs(best - mean);
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i) {
        const double x = mean - reach + 2.0 * reach * i / (kPoints - 1);
        sum += std::exp(-0.5 * information * (x - best) * (x - best) -
                        0.5 * (x - mean) * (x - mean) / (deviation * deviation));
    }
    return std::log(sum * 2.0 * reach / (kPoints - 1) / (deviation * std::sqrt(2.0 * std::numbers::pi)));
}

/// A fit of two numbers to a Gaussian likelihood with its maximum at `best`.
Fit gaussian_fit(const Eigen::Vector2d& best, const Eigen::Matrix2d& information) {
    Fit fit;
    fit.unknowns = {{.name = "first", .mean = 0.0, .deviation = 0.1},
                    {.name = "second", .mean = 0.2, .deviation = 0.5}};
    Eigen::Matrix2d curvature = information;
    Eigen::Vector2d right = information * best;
    for (int i = 0; i < 2; ++i) {
        const double weight = 1.0 / (fit.unknowns[i].deviation * fit.unknowns[i].deviation);
        curvature(i, i) += weight;
        right(i) += weight * fit.unknowns[i].mean;
    }
    const Eigen::Vector2d values = curvature.ldlt().solve(right);
    fit.values = {values(0), values(1)};
    fit.information = information;
    fit.covariance = curvature.inverse();
    fit.gradient = Eigen::VectorXd::Zero(2);
    return fit;
}

TEST(ReleaseGain, IsTheRatioOfEvidences) {
    const Eigen::Vector2d best(0.45, -0.1);
    Eigen::Matrix2d information;
    information << 400.0, 60.0, 60.0, 90.0;
    const Fit fit = gaussian_fit(best, information);
    for (const std::size_t own : {0u, 1u}) {
        // The other unknown integrated out, closed form: what is left is Gaussian in this one.
        const long i = static_cast<long>(own), j = 1 - i;
        const Unknown& other = fit.unknowns[static_cast<std::size_t>(j)];
        const double w = 1.0 / (other.deviation * other.deviation), fjj = information(j, j) + w;
        const double marginal = information(i, i) - information(i, j) * information(i, j) / fjj;
        // ∂/∂x_i of the marginal at x: −F_ii(x − a_i) + F_ij/(F_jj + w)·[F_ij(x − a_i) + w(m_j − a_j)] … zero at:
        const double peak = best(i) - information(i, j) * w * (other.mean - best(j)) / (fjj * marginal);
        const double mean = fit.unknowns[own].mean, narrow = fit.unknowns[own].deviation;
        const double expected = log_evidence(peak, marginal, mean, 1.15) - log_evidence(peak, marginal, mean, narrow);
        EXPECT_NEAR(release_gain(fit, own, 1.15), expected, 1e-6) << own;
    }
}

TEST(ReleaseGain, NothingWhereTheDataSayNothing) {
    const Fit fit = gaussian_fit({0.3, 0.0}, Eigen::Matrix2d(Eigen::Vector2d(0.0, 50.0).asDiagonal()));
    EXPECT_EQ(release_gain(fit, 0, 1.15), 0.0);
}

// A power cannot be negative: forces of the secondary suspension that are not there promise nothing that the factor on
// its stiffness alone does not promise.
TEST(PromisesOf, PowersDoNotFall) {
    Synthesised made =
        synthesised(paper_believed({"vehicle.primary.stiffness_n_per_m"}), {20.0}, 60.0, nine_channels(), kSmall);
    made.draw(22);
    const std::vector<Unknown> own = nuisance_unknowns(made.believed, made.observations);
    const Fit fitted = fit(believed_trial(made.believed, made.observations), own, means(own), made.context());
    const CorrectionPlace forces{.element = Element::secondary, .channel = {}, .forces = true};
    const std::vector<Unknown> freedom = correction_unknowns(forces, made.observations);
    const FreedomPromise promise = promises_of(fitted, {freedom}, made.context()).front();
    int powers = 0, kept = 0;
    for (std::size_t i = 0; i < freedom.size(); ++i) {
        if (freedom[i].low < freedom[i].mean) continue;
        ++powers;
        const double value = promise.values(static_cast<long>(i)),
                     variance = promise.covariance(static_cast<long>(i), static_cast<long>(i));
        EXPECT_GE(value, 0.0) << freedom[i].name;
        EXPECT_EQ(variance > 0.0, value > 0.0) << freedom[i].name;
        kept += value > 0.0;
    }
    EXPECT_EQ(powers, static_cast<int>(correction_nodes(forces, made.observations).size()));
    EXPECT_LT(kept, powers);  // by chance every second would fall
}

// A fit and a freedom whose likelihood is nearly Gaussian: many averages, a small truth. The promise must be what the
// evidences of the two fits differ by. Second order in what is missing: a mass off by 6 % leaves some 10 % of the nats.
TEST(PromisesOf, IsTheDifferenceOfTheEvidencesOfTwoFits) {
    Synthesised made =
        synthesised(paper_believed({"vehicle.primary.stiffness_n_per_m", "vehicle.primary.damping_n_s_per_m"}), {20.0},
                    300.0, {"body", "bogie_1", "wheel_1"}, {.window_s = 1.0, .low_hz = 4.0, .high_hz = 40.0});
    number_at(made.truth.numbers, "vehicle.bogie_mass_kg") *= 1.06;
    made.draw(21);
    std::vector<Unknown> own = nuisance_unknowns(made.believed, made.observations);
    std::erase_if(own, [](const Unknown& unknown) { return unknown.kind == UnknownKind::floor; });
    FitOptions exact;
    exact.least_gain = 1e-6;
    exact.iterations = 20;
    const Fit without = fit(believed_trial(made.believed, made.observations), own, means(own), made.context(), exact);
    const double mass = number_at(made.believed.numbers, "vehicle.bogie_mass_kg");
    const std::vector<Unknown> freedom = {{.kind = UnknownKind::number,
                                           .name = "vehicle.bogie_mass_kg",
                                           .deviation = 0.2,
                                           .low = -1.0,
                                           .high = 1.0,
                                           .set = [mass](Trial& trial, double x) {
                                               number_at(trial.numbers, "vehicle.bogie_mass_kg") = mass * std::exp(x);
                                           }}};
    const FreedomPromise promise = promises_of(without, {freedom}, made.context()).front();
    std::vector<Unknown> all = own;
    all.push_back(freedom.front());
    std::vector<double> start = without.values;
    start.push_back(0.0);
    exact.from_far = false;
    const Fit with = fit(believed_trial(made.believed, made.observations), all, start, made.context(), exact);
    const double gained = with.log_evidence - without.log_evidence;
    std::printf("promised %.2f, gained %.2f nats; value %.4f ± %.4f, fitted %.4f\n", promise.nats, gained,
                promise.values(0), std::sqrt(promise.covariance(0, 0)), with.values.back());
    EXPECT_GT(gained, 2.0);
    EXPECT_NEAR(promise.nats, gained, 0.1 * gained + 0.3);
    EXPECT_NEAR(promise.values(0), with.values.back(), 0.5 * with.deviation(all.size() - 1));
    EXPECT_NEAR(std::sqrt(promise.covariance(0, 0)), with.deviation(all.size() - 1),
                0.15 * with.deviation(all.size() - 1));
}

}  // namespace
}  // namespace railpem::diagnosis

#include "diagnosis/fit/bounded_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <random>

namespace railpem::diagnosis {
namespace {

TEST(BoundedStep, IsNewtonsWhereNothingIsInItsWay) {
    const Eigen::Matrix2d curvature{{4.0, 1.0}, {1.0, 3.0}};
    const Eigen::Vector2d gradient(1.0, -2.0), far = Eigen::Vector2d::Constant(10.0);
    EXPECT_LT((bounded_step(curvature, gradient, -far, far) - curvature.ldlt().solve(gradient)).norm(), 1e-14);
}

// Two unknowns of which only the sum is known well: cut off each by itself, the sum would be wrong by all that was cut
// off.
TEST(BoundedStep, SeeksTheOthersBesideWhatIsStopped) {
    const Eigen::Matrix2d curvature{{100.01, 100.0}, {100.0, 100.01}};
    const Eigen::Vector2d newton(5.0, -4.0), gradient = curvature * newton, low(-10.0, -10.0), high(1.0, 10.0);
    const Eigen::VectorXd step = bounded_step(curvature, gradient, low, high);
    EXPECT_DOUBLE_EQ(step(0), 1.0);
    EXPECT_NEAR(step(1), (gradient(1) - 100.0) / 100.01, 1e-12);
}

// The conditions that only the maximum fulfils (Karush, Kuhn, Tucker): no pull where an unknown is free, a pull
// outwards where it is held.
TEST(BoundedStep, PullsOutwardsOnlyAtItsBounds) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    for (int draw = 0; draw < 200; ++draw) {
        const long size = 1 + draw % 12;
        const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
        const Eigen::MatrixXd curvature = root * root.transpose() + 1e-3 * Eigen::MatrixXd::Identity(size, size);
        const Eigen::VectorXd gradient = Eigen::VectorXd::NullaryExpr(size, [&] { return 3.0 * normal(random); });
        Eigen::VectorXd low = Eigen::VectorXd::NullaryExpr(size, [&] { return std::min(0.0, normal(random)); }),
                        high = Eigen::VectorXd::NullaryExpr(size, [&] { return std::max(0.0, normal(random)); });
        if (size > 3) low(1) = high(1) = 0.0;
        const Eigen::VectorXd step = bounded_step(curvature, gradient, low, high), pull = gradient - curvature * step;
        for (long u = 0; u < size; ++u) {
            EXPECT_GE(step(u), low(u));
            EXPECT_LE(step(u), high(u));
            const double allowed = 1e-4 * (1.0 + curvature(u, u));  // what is worth less than 1e-9 nats stays held
            EXPECT_TRUE(step(u) == high(u) || pull(u) < allowed) << draw << " " << u;
            EXPECT_TRUE(step(u) == low(u) || pull(u) > -allowed) << draw << " " << u;
        }
    }
}

// The first is held at its bound until the second has moved; letting it go then gains 0.32 nats by itself.
TEST(BoundedStep, LetsGoOfWhatGainsMoreThanItsSettingsAsk) {
    const Eigen::Matrix2d curvature{{1.0, 0.9}, {0.9, 1.0}};
    const Eigen::Vector2d gradient(0.1, 1.0), low(-10.0, -10.0), high(0.0, 10.0);
    EXPECT_LT(bounded_step(curvature, gradient, low, high)(0), -1.0);
    FitSettings asks_more;
    asks_more.worth_letting_go = 0.33;
    EXPECT_EQ(bounded_step(curvature, gradient, low, high, asks_more)(0), 0.0);
}

}  // namespace
}  // namespace railpem::diagnosis

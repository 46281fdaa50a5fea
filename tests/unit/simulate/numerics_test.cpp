#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "simulate/numerics/block_tridiagonal.hpp"
#include "simulate/numerics/nonnegative_least_squares.hpp"
#include "simulate/numerics/radau_step.hpp"
#include "simulate/numerics/random_numbers.hpp"
#include "simulate/track/beam_element.hpp"

namespace railpem::simulate {
namespace {

using std::numbers::pi;

/// Error after one period of m·ü + k·u = 0, u(0) = 1, with ω = 1.
double period_error(int steps) {
    const RadauStep step(2.0 * pi / steps);
    double u = 1.0;
    double v = 0.0;
    for (int i = 0; i < steps; ++i) {
        const Complex next = step.one * step.s * (step.s * u + v) / (step.s * step.s + 1.0);
        v = RadauStep::at_end(step.derivative(next, u));
        u = RadauStep::at_end(next);
    }
    return std::hypot(u - 1.0, v);
}

TEST(RadauStep, TransformAndBack) {
    const RadauStep step(1e-3);
    const Complex value = step.transform(3.0, -7.0);
    EXPECT_NEAR(step.at_first(value), 3.0, 1e-12);
    EXPECT_NEAR(RadauStep::at_end(value), -7.0, 1e-12);
    EXPECT_NEAR(RadauStep::at_end(step.derivative(step.transform(2.0 + 1.0 / 3.0, 3.0), 2.0)) * step.step_s, 1.0, 1e-12)
        << "u = 2 + t/h";
}

TEST(RadauStep, ThirdOrder) {
    const double order = std::log2(period_error(80) / period_error(160));
    EXPECT_NEAR(order, 3.0, 0.05);
}

TEST(RadauStep, DampsWhatItCannotResolve) {
    const RadauStep step(1.0);
    const double omega2 = 1e12;
    const Complex next = step.one * step.s * step.s / (step.s * step.s + omega2);
    EXPECT_LT(std::abs(RadauStep::at_end(next)), 1e-6);
}

Section rail(bool shears) {
    track::RailParameters r{.youngs_modulus_pa = 2.06e11, .second_moment_of_area_m4 = 3.22e-5, .mass_kg_per_m = 60.64};
    if (shears) r.beam = track::Beam::timoshenko;
    return section_of(r);
}

TEST(BeamElement, CompliancesBetweenNodes) {
    const Section euler = rail(false);
    const double l = 0.3;
    for (const double a : {0.02, 0.1, 0.15, 0.29}) {
        const double b = l - a;
        EXPECT_NEAR(compliance_between_nodes(euler, l, a) * 3.0 * euler.bending_rigidity_n_m2 * l * l * l /
                        (a * a * a * b * b * b),
                    1.0, 1e-12);
    }
    // Midspan of a clamped Timoshenko beam: P·l³/(192·EI) + P·l/(4·κGA).
    const Section shearing = rail(true);
    const double expected =
        l * l * l / (192.0 * shearing.bending_rigidity_n_m2) + 0.25 * l * shearing.shear_flexibility_per_n;
    EXPECT_NEAR(compliance_between_nodes(shearing, l, 0.5 * l) / expected, 1.0, 1e-12);
    EXPECT_EQ(compliance_between_nodes(shearing, l, 0.0), 0.0);
}

// A clamped–free rail of three elements, loaded anywhere: the tip must follow P·a²·(3L − a)/(6·EI) + P·a/(κGA) exactly.
TEST(BeamElement, NodesAreExactWhereverTheLoadStands) {
    for (const bool shears : {false, true}) {
        const Section s = rail(shears);
        const double l = 0.3;
        Eigen::Matrix<double, 8, 8> k = Eigen::Matrix<double, 8, 8>::Zero();
        for (int e = 0; e < 3; ++e) k.block<4, 4>(2 * e, 2 * e) += element_stiffness(s, l);
        for (const double a : {0.05, 0.31, 0.47, 0.88}) {
            const int e = static_cast<int>(a / l);
            Eigen::Matrix<double, 8, 1> load = Eigen::Matrix<double, 8, 1>::Zero();
            load.segment<4>(2 * e) = displacement_shape(s, l, a - e * l);
            const Eigen::VectorXd u = k.bottomRightCorner<6, 6>().ldlt().solve(load.tail<6>());
            const double tip =
                a * a * (3.0 * 0.9 - a) / (6.0 * s.bending_rigidity_n_m2) + a * s.shear_flexibility_per_n;
            EXPECT_NEAR(u[4] / tip, 1.0, 1e-9) << shears << " " << a;
        }
    }
}

TEST(BeamElement, RigidMotionCarriesTheWholeMass) {
    for (const bool shears : {false, true}) {
        const Section s = rail(shears);
        const Eigen::Matrix4d m = element_mass(s, 0.3);
        const Eigen::Vector4d heave(1.0, 0.0, 1.0, 0.0);
        const Eigen::Vector4d turn(-0.15, 1.0, 0.15, 1.0);
        EXPECT_NEAR(heave.dot(m * heave), 0.3 * 60.64, 1e-10);
        EXPECT_NEAR(turn.dot(m * turn), 60.64 * 0.3 * 0.3 * 0.3 / 12.0 + 0.3 * s.rotary_inertia_kg_m, 1e-10);
        EXPECT_LT((element_stiffness(s, 0.3) * turn).norm(), 1e-6);
    }
}

class BlockTridiagonalOf : public testing::TestWithParam<int> {};

TEST_P(BlockTridiagonalOf, SolvesWhatADenseSolverSolves) {
    const int n = GetParam();
    BlockTridiagonal matrix;
    Eigen::MatrixXcd dense = Eigen::MatrixXcd::Zero(2 * n, 2 * n);
    const auto number = [](std::uint64_t i) {
        return Complex(uniform_at(5, 2 * i) - 0.5, uniform_at(5, 2 * i + 1) - 0.5);
    };
    for (int node = 0; node < n; ++node) {
        const auto k = static_cast<std::uint64_t>(node);
        const Complex off = number(10 * k);
        matrix.diagonal.push_back({number(10 * k + 1) + 4.0, off, off, number(10 * k + 2) + 4.0});
        if (node + 1 < n)
            matrix.upper.push_back({number(10 * k + 3), number(10 * k + 4), number(10 * k + 5), number(10 * k + 6)});
    }
    std::vector<Pair> values;
    Eigen::VectorXcd right(2 * n);
    for (int k = 0; k < n; ++k) {
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j) {
                dense(2 * k + i, 2 * k + j) = matrix.diagonal[k][2 * i + j];
                if (k + 1 == n) continue;
                dense(2 * k + i, 2 * k + 2 + j) = matrix.upper[k][2 * i + j];
                dense(2 * k + 2 + j, 2 * k + i) = matrix.upper[k][2 * i + j];
            }
        right[2 * k] = number(900 + k);
        right[2 * k + 1] = number(950 + k);
        values.push_back({right[2 * k], right[2 * k + 1]});
    }
    BlockFactors factors;
    factorise(matrix, factors);
    solve(factors, values);
    const Eigen::VectorXcd expected = dense.partialPivLu().solve(right);
    for (int k = 0; k < n; ++k) {
        EXPECT_LT(std::abs(values[k].w - expected[2 * k]), 1e-13);
        EXPECT_LT(std::abs(values[k].theta - expected[2 * k + 1]), 1e-13);
    }
}

INSTANTIATE_TEST_SUITE_P(OddAndEven, BlockTridiagonalOf, testing::Values(2, 3, 7, 8));

TEST(NonnegativeLeastSquares, HoldsNegativeComponentsAtZero) {
    Eigen::MatrixXd a(3, 2);
    a << 1, 0, 0, 1, 1, 1;
    const Eigen::VectorXd x = nonnegative_least_squares(a, Eigen::Vector3d(2.0, -1.0, 1.0));
    EXPECT_NEAR(x[0], 1.5, 1e-12);  // min (x−2)² + (x−1)² with the second at zero
    EXPECT_EQ(x[1], 0.0);
    const Eigen::VectorXd inner = nonnegative_least_squares(a, a * Eigen::Vector2d(0.3, 4.0));
    EXPECT_NEAR(inner[0], 0.3, 1e-12);
    EXPECT_NEAR(inner[1], 4.0, 1e-12);
}

TEST(RandomNumbers, NormalAndReproducible) {
    double sum = 0.0;
    double squares = 0.0;
    constexpr int n = 20000;
    for (std::uint64_t i = 0; i < n; ++i) {
        const auto [a, b] = normal_pair_at(3, i);
        sum += a + b;
        squares += a * a + b * b;
    }
    // Standard errors: 1/√40000 = 0.005 of the mean, √(2/40000) = 0.007 of the variance; four of them.
    EXPECT_NEAR(sum / (2 * n), 0.0, 0.02);
    EXPECT_NEAR(squares / (2 * n), 1.0, 0.028);
    EXPECT_EQ(bits_at(7, 9), bits_at(7, 9));
    EXPECT_NE(derived_seed(7, 1), derived_seed(7, 2));
}

}  // namespace
}  // namespace railpem::simulate

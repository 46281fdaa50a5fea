#include "track/elements/static_beam_element.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace railpem::track {
namespace {

constexpr double bending = 6.6e6, shear = 2.5e8;  // EI and κGA of a 60 kg/m rail

StaticBeamElement element(double length, bool shears) {
    return {length, bending, shears ? 12.0 * bending / (shear * length * length) : 0.0};
}

/// Two elements of unequal length in one matrix: nodes near, middle, far.
Eigen::Matrix<double, 6, 6> pair(double a, double b, bool shears) {
    Eigen::Matrix<double, 6, 6> k = Eigen::Matrix<double, 6, 6>::Zero();
    k.topLeftCorner<4, 4>() += element_stiffness(element(a, shears));
    k.bottomRightCorner<4, 4>() += element_stiffness(element(b, shears));
    return k;
}

TEST(StaticBeamElement, TipOfACantilever) {
    for (const bool shears : {false, true}) {
        const double h = 0.6;
        const Eigen::Vector2d tip =
            element_stiffness(element(h, shears)).bottomRightCorner<2, 2>().inverse() * Eigen::Vector2d(1.0, 0.0);
        EXPECT_NEAR(tip[0] / (h * h * h / (3.0 * bending) + (shears ? h / shear : 0.0)), 1.0, 1e-13);
        EXPECT_NEAR(tip[1] / (h * h / (2.0 * bending)), 1.0, 1e-13);
    }
}

/// Exactness: an inner node, eliminated, leaves the long element; a load there leaves the loads of its shape functions.
TEST(StaticBeamElement, InnerNodesChangeNothing) {
    const double a = 0.17, b = 0.43;
    for (const bool shears : {false, true}) {
        const Eigen::Matrix<double, 6, 6> k = pair(a, b, shears);
        Eigen::Matrix4d outer, one = element_stiffness(element(a + b, shears));
        Eigen::Matrix<double, 4, 2> cross;
        outer << k.topLeftCorner<2, 2>(), Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero(), k.bottomRightCorner<2, 2>();
        cross << k.block<2, 2>(0, 2), k.block<2, 2>(4, 2);
        const Eigen::Matrix<double, 4, 2> carried = -cross * k.block<2, 2>(2, 2).inverse();
        EXPECT_LE((outer + carried * cross.transpose() - one).cwiseAbs().maxCoeff(), 1e-12 * k.cwiseAbs().maxCoeff());
        const Eigen::Vector4d load = carried.col(0);  // of a unit force at the middle node
        EXPECT_LE((load - element_shape(element(a + b, shears), a / (a + b))).cwiseAbs().maxCoeff(), 1e-13);
    }
}

TEST(StaticBeamElement, UniformLoadIsTheSumOfItsPointLoads) {
    for (const bool shears : {false, true}) {
        const StaticBeamElement whole = element(0.6, shears);
        Eigen::Vector4d sum = Eigen::Vector4d::Zero();
        const double gauss = 0.5 * std::sqrt(0.6);  // three points: exact for the cubic shapes
        sum += 5.0 / 18.0 * element_shape(whole, 0.5 - gauss) + 4.0 / 9.0 * element_shape(whole, 0.5) +
               5.0 / 18.0 * element_shape(whole, 0.5 + gauss);
        EXPECT_LE((0.6 * sum - element_uniform_load(whole)).cwiseAbs().maxCoeff(), 1e-15);
    }
}

}  // namespace
}  // namespace railpem::track

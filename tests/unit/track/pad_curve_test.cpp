#include "track/pads/pad_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "parameters/parameter_error.hpp"
#include "tests/unit/track/wei2016_track.hpp"

namespace railpem::track {
namespace {

using parameters::ParameterError;

// Equation (2) of the paper in its own units, kN and mm.
double paper_force_kn(double s) {
    return 0.0401 * s * s * s * s + 0.1228 * s * s * s + 3.368 * s * s + 5.021 * s - 0.4518;
}

PadParameters sampled_pads(int points, double from_mm, double to_mm) {
    PadParameters pads = wei2016_track().pads;
    pads.force_polynomial_n.clear();
    for (int i = 0; i < points; ++i) {
        const double s = from_mm + (to_mm - from_mm) * i / (points - 1);
        pads.curve_compression_m.push_back(1e-3 * s);
        pads.curve_force_n.push_back(1e3 * paper_force_kn(s));
    }
    return pads;
}

TEST(PadCurve, PolynomialIsThePaperEquation) {
    const PadCurve curve = pad_curve(wei2016_track().pads);
    for (const double s : {0.5, 1.78, 2.865, 3.36})
        EXPECT_NEAR(pad_force(curve, 1e-3 * s), 1e3 * paper_force_kn(s), 1e-9 * 1e3 * paper_force_kn(s));  // rounding
    // K at the compressions of the published equilibrium: 19.1 and 37.9 kN/mm, three digits quoted.
    EXPECT_NEAR(pad_stiffness(curve, 1.78e-3), 19.1e6, 0.05e6);
    EXPECT_NEAR(pad_stiffness(curve, 3.36e-3), 37.9e6, 0.05e6);
}

TEST(PadCurve, StiffnessIsTheDerivative) {
    for (const PadParameters& pads : {wei2016_track().pads, sampled_pads(7, 0.0, 3.5)}) {
        const PadCurve curve = pad_curve(pads);
        const double h = 1e-8;
        for (const double s : {0.3e-3, 1.1e-3, 2.2e-3, 3.1e-3, 5e-3}) {
            const double difference = (pad_force(curve, s + h) - pad_force(curve, s - h)) / (2.0 * h);
            EXPECT_NEAR(pad_stiffness(curve, s), difference, 1e-6 * difference);  // rounding of F over h
        }
    }
}

TEST(PadCurve, CarriesNothingBelowZeroForce) {
    const PadCurve curve = pad_curve(wei2016_track().pads);
    EXPECT_NEAR(paper_force_kn(1e3 * curve.free_compression_m), 0.0, 1e-12);
    EXPECT_GT(curve.free_compression_m, 0.08e-3);  // F(0) = −0.4518 kN: the published fit is zero at 0.085 mm
    for (const double below : {0.0, -1e-3, 0.99 * curve.free_compression_m}) {
        EXPECT_EQ(pad_force(curve, below), 0.0);
        EXPECT_EQ(pad_stiffness(curve, below), 0.0);
    }
}

TEST(PadCurve, TangentGoesOnBeyondTheLimit) {
    const PadCurve curve = pad_curve(wei2016_track().pads);
    const double limit = curve.limit_compression_m;
    EXPECT_NEAR(pad_force(curve, limit), 90e3, 1e-6);
    EXPECT_NEAR(pad_force(curve, limit * (1.0 + 1e-12)), 90e3, 1e-3);  // continuous
    const double slope = pad_stiffness(curve, limit);
    EXPECT_EQ(pad_stiffness(curve, 2.0 * limit), slope);
    EXPECT_NEAR(pad_force(curve, limit + 1e-3), 90e3 + 1e-3 * slope, 1e-6);
}

TEST(PadCurve, CompressionInvertsForce) {
    PadParameters linear;
    linear.static_stiffness_n_per_m = 26.7e6;
    for (const PadParameters& pads :
         {wei2016_track().pads, sampled_pads(9, 0.0, 4.0), sampled_pads(5, 0.5, 3.0), linear}) {
        const PadCurve curve = pad_curve(pads);
        for (const double force : {1.0, 500.0, 20e3, 60e3, 90e3, 150e3})
            EXPECT_NEAR(pad_force(curve, pad_compression(curve, force)), force,
                        1e-12 * 1e5 + 1e-10 * force);  // one ulp of S
        EXPECT_EQ(pad_compression(curve, 0.0), curve.free_compression_m);
    }
}

TEST(PadCurve, PointsConvergeToTheCurveTheyWereTakenFrom) {
    // Where the data rise and bend one way the harmonic-mean slopes are second-order accurate, hence the curve
    // third-order.
    const auto error = [](int points) {
        const PadCurve curve = pad_curve(sampled_pads(points, 0.0, 4.0));
        double largest = 0.0;
        for (double s = 0.5; s < 3.4; s += 0.01)
            largest = std::max(largest, std::abs(pad_force(curve, 1e-3 * s) - 1e3 * paper_force_kn(s)));
        return largest;
    };
    const double coarse = error(11), fine = error(41);
    EXPECT_LT(fine, 10.0);                                    // of 60 kN
    EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 2.7);  // observed order, 3 in the limit
}

// Up and down, in steps and jumps, below zero force and beyond the last point.
TEST(PadCurve, ForceFromAKnownPieceIsTheSame) {
    PadParameters pads;
    pads.static_stiffness_n_per_m = 26.7e6;
    const PadCurve straight = pad_curve(pads);
    for (int i = 0; i <= 40; ++i)
        pads.curve_compression_m.push_back(1e-4 * i), pads.curve_force_n.push_back(1e3 * i + 20.0 * i * i);
    const PadCurve curve = pad_curve(pads);
    std::size_t piece = 1000;
    for (const double s : {1e-3, 1.05e-3, 3.9e-3, 0.0, -1e-3, 2e-4, 1e-4, 5e-3, 2.22e-3, 4e-3})
        EXPECT_EQ(pad_force(curve, s, piece), pad_force(curve, s)) << s;
    EXPECT_EQ(pad_force(straight, 1e-3, piece), pad_force(straight, 1e-3));
}

TEST(PadCurve, PointsStayMonotoneAndPassThroughTheData) {
    PadParameters pads;
    pads.static_stiffness_n_per_m = 26.7e6;
    pads.curve_compression_m = {0.0, 1e-3, 1.1e-3, 2e-3, 4e-3};
    pads.curve_force_n = {-100.0, 1e3, 30e3, 31e3, 80e3};  // a cubic spline would overshoot here
    const PadCurve curve = pad_curve(pads);
    for (std::size_t i = 1; i < pads.curve_force_n.size(); ++i)
        EXPECT_NEAR(pad_force(curve, pads.curve_compression_m[i]), pads.curve_force_n[i], 1e-7);
    double before = 0.0;
    for (double s = curve.free_compression_m + 1e-6; s < 6e-3; s += 1e-6) {
        EXPECT_GT(pad_force(curve, s), before);
        before = pad_force(curve, s);
    }
    EXPECT_EQ(curve.limit_force_n, 80e3) << "the last point ends the curve, not curve_limit_n beyond it";
}

TEST(PadCurve, PointsThatBeginAboveZeroAreContinuedDownwards) {
    const PadCurve curve = pad_curve(sampled_pads(9, 1.0, 4.0));
    EXPECT_GT(curve.free_compression_m, 0.0);
    EXPECT_LT(curve.free_compression_m, 1e-3);
    EXPECT_NEAR(pad_force(curve, 1e-3), 1e3 * paper_force_kn(1.0), 1e-8);
    EXPECT_NEAR(pad_stiffness(curve, 0.9e-3), pad_stiffness(curve, 1e-3), 1e-3);
}

TEST(PadCurve, LinearWithoutACurve) {
    PadParameters pads;
    pads.static_stiffness_n_per_m = 26.7e6;
    const PadCurve curve = pad_curve(pads);
    EXPECT_DOUBLE_EQ(pad_force(curve, 10e-3), 267e3);
    EXPECT_EQ(pad_stiffness(curve, 10e-3), 26.7e6);
    EXPECT_EQ(pad_force(curve, -1e-3), 0.0);
    EXPECT_TRUE(std::isinf(curve.limit_force_n));
}

TEST(PadCurve, RefusesCurvesThatAreNoStaticLaw) {
    PadParameters pads = wei2016_track().pads;
    pads.force_polynomial_n = {0.0, 26.7e6, -5e9};  // turns back at 35.6 kN
    EXPECT_THROW(pad_curve(pads), ParameterError);
    pads.force_polynomial_n = {-1000.0};
    EXPECT_THROW(pad_curve(pads), ParameterError);
    pads.force_polynomial_n = {1000.0, 0.0, 1e9};  // positive everywhere
    EXPECT_THROW(pad_curve(pads), ParameterError);
    pads = sampled_pads(5, 3.0, 4.0);
    pads.curve_limit_n = 1e3;
    EXPECT_THROW(pad_curve(pads), ParameterError);
    pads.curve_force_n = {-5.0, -4.0, -3.0, -2.0, -1.0};
    EXPECT_THROW(pad_curve(pads), ParameterError);
}

}  // namespace
}  // namespace railpem::track

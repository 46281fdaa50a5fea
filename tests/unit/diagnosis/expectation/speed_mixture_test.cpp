// What speeds that change do to the coherence between wheels.

#include "diagnosis/expectation/speed_mixture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace railpem::diagnosis {
namespace {

using Complex = std::complex<double>;

constexpr double kTwoPi = 2.0 * std::numbers::pi;
const std::vector<double> kWheels_m{10.2, 7.8, -7.8, -10.2};

recordings::TrackPath wandering(double swing, double period_s, double seconds) {
    std::vector<double> time, speed;
    for (double t = 0.0; t <= seconds; t += 0.05) {
        time.push_back(t);
        speed.push_back(20.0 / (1.0 + swing * std::sin(kTwoPi * t / period_s)));  // the slowness is a sine
    }
    return recordings::track_path(time, speed, 0.05, seconds);
}

SpeedMixture mixture(double swing, double error = 0.0) {
    const recordings::Segmentation segments{recordings::Window::hann, 800, 400, 499};  // 4 s windows over 1000 s
    // A whole number of periods, and none of hops in one: windows count their middles more than their ends.
    return {wandering(swing, 1000.0 / 62.0, 1000.0), segments, 200.0, 0.0, 20.0, error, 200.0};
}

TEST(SpeedMixture, OneSpeedIsWhollyCoherent) {
    const SpeedMixture one = mixture(0.0);
    for (const double x : {0.0, 1.0, 77.0, 199.0}) EXPECT_NEAR(std::abs(one.at(x)[0] - 1.0), 0.0, 1e-9);
    EXPECT_EQ(one.least(), 0.0);
    EXPECT_EQ(one.most(), 0.0);
}

// E[e^{-i2πxa·sin θ}] with θ even over the circle is J0(2πxa) (Abramowitz & Stegun 9.1.18).
TEST(SpeedMixture, OfASineIsABesselFunction) {
    const SpeedMixture own = mixture(0.01);
    for (double x = 0.0; x < 150.0; x += 7.3) {
        // The first and the last 2 s count half: 4e-3 of the record.
        EXPECT_NEAR(own.at(x)[0].real(), std::cyl_bessel_j(0, kTwoPi * x * 0.01), 4e-3) << x;
        EXPECT_NEAR(own.at(x)[0].imag(), 0.0, 4e-3) << x;
        // E[δ·e^{−i2πxδ}] is the derivative of the first, over −2πi: −i·a·J1.
        EXPECT_NEAR(own.at(x)[1].imag(), -0.01 * std::cyl_bessel_j(1, kTwoPi * x * 0.01), 5e-5) << x;
    }
    EXPECT_LT(std::abs(own.at(-33.0)[0] - std::conj(own.at(33.0)[0])), 1e-15);
}

TEST(SpeedMixture, WhatChanceAddsToTheSpreadIsTakenOff) {
    const double swing = 0.01, error = 0.005;  // rms of the sine: 0.00707
    const double kept = std::sqrt(1.0 - error * error / (0.5 * swing * swing));
    const SpeedMixture all = mixture(swing), less = mixture(swing, error);
    // The ends of the record, 4e-3 of it, are in the variance too.
    EXPECT_NEAR((less.most() - less.least()) / (all.most() - all.least()), kept, 4e-3);
}

TEST(WheelCoherence, IsTheFactorOfWhatTheMixtureSays) {
    const SpeedMixture own = mixture(0.01);
    const double f = 60.0, slope = -3.0;
    const WheelCoherence factor = wheel_coherence(own, kWheels_m, 20.0, f, slope);
    const double mean = 1.0 + (1.0 + slope) * own.at(0.0)[1].real();
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t l = 0; l <= j; ++l) {
            Complex product = 0.0;
            for (std::size_t r = 0; r < 4; ++r) product += factor[j][r] * std::conj(factor[l][r]);
            const auto [phi, first] = own.at(f * (kWheels_m[l] - kWheels_m[j]) / 20.0);
            const Complex expected = j == l ? Complex(1.0) : (phi + (1.0 + slope) * first) / mean;
            EXPECT_LT(std::abs(product - expected), 1e-9) << j << l;
        }
    // Wheels of one bogie stay together where those of two are torn apart.
    EXPECT_GT(std::abs(factor[1][0]), 0.9);
    EXPECT_LT(std::abs(factor[3][0]), 0.5);
}

}  // namespace
}  // namespace railpem::diagnosis

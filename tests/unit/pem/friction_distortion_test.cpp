// Friction beyond its equivalent damping: against random realisations, and the total power in closed form.

#include "pem/coupling/friction_distortion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace railpem::pem {
namespace {

constexpr double kVelocityStep_hz = 0.5;
constexpr std::size_t kVelocityLines = 240;  ///< to 120 Hz

/// Two velocities with a shared and an own part around 8 Hz.
VelocitySpectra two_velocities() {
    VelocitySpectra own{
        .from_hz = kVelocityStep_hz, .step_hz = kVelocityStep_hz, .elements = 2, .lines = kVelocityLines, .values = {}};
    for (std::size_t k = 0; k < kVelocityLines; ++k) {
        const double f = kVelocityStep_hz * static_cast<double>(k + 1),
                     level = 1e-4 * std::exp(-0.5 * std::pow((f - 8.0) / 2.0, 2));
        const std::complex<double> cross = 0.6 * level * std::polar(1.0, -2.0 * std::numbers::pi * f * 0.02);
        own.values.insert(own.values.end(), {level, cross, std::conj(cross), level});
    }
    return own;
}

double band_power(const std::vector<std::complex<double>>& psd, std::size_t entry, double from, double to) {
    double sum = 0.0;
    for (std::size_t k = 0; k < kVelocityLines; ++k)
        if (const double f = kVelocityStep_hz * static_cast<double>(k + 1); f >= from && f < to)
            sum += psd[4 * k + entry].real() * kVelocityStep_hz;
    return sum;
}

/// Mean power of F·sgn(v) − c·v in a band over random realisations of one velocity.
double realised_power(double force, double from, double to) {
    constexpr int kDraws = 60;
    constexpr std::size_t kSamples = 1024;  // over one period 1/step
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const VelocitySpectra spectra = two_velocities();
    double variance = 0.0, sum = 0.0;
    for (std::size_t k = 0; k < kVelocityLines; ++k) variance += spectra.values[4 * k].real() * kVelocityStep_hz;
    const double damping = force * std::sqrt(2.0 / std::numbers::pi) / std::sqrt(variance);
    for (int draw = 0; draw < kDraws; ++draw) {
        std::vector<double> v(kSamples, 0.0), rest(kSamples);
        for (std::size_t k = 0; k < 60; ++k) {
            const double amplitude = std::sqrt(spectra.values[4 * k].real() * kVelocityStep_hz),
                         a = amplitude * normal(random), b = amplitude * normal(random);
            for (std::size_t m = 0; m < kSamples; ++m) {
                const double angle = 2.0 * std::numbers::pi * static_cast<double>((k + 1) * m % kSamples) / kSamples;
                v[m] += a * std::cos(angle) + b * std::sin(angle);
            }
        }
        for (std::size_t m = 0; m < kSamples; ++m) rest[m] = (v[m] > 0.0 ? force : -force) - damping * v[m];
        for (std::size_t k = 0; k < kVelocityLines; ++k) {
            if (const double f = kVelocityStep_hz * static_cast<double>(k + 1); f < from || f >= to) continue;
            std::complex<double> own;
            for (std::size_t m = 0; m < kSamples; ++m)
                own += rest[m] * std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>((k + 1) * m % kSamples) /
                                                     kSamples);
            sum += 2.0 * std::norm(own) / kSamples / kSamples / kDraws;
        }
    }
    return sum;
}

TEST(FrictionDistortion, IsWhatRealisationsLeave) {
    constexpr double kForce = 700.0;
    const std::vector<std::complex<double>> psd = friction_distortion(two_velocities(), kForce);
    // 60 draws of some ten independent lines each: 2 to 6 %; three of those deviations.
    for (const auto& [from, to, tolerance] :
         {std::tuple(4.0, 12.0, 0.2), std::tuple(18.0, 30.0, 0.1), std::tuple(30.0, 60.0, 0.1)})
        EXPECT_NEAR(band_power(psd, 0, from, to) / realised_power(kForce, from, to), 1.0, tolerance) << from;
}

TEST(FrictionDistortion, HasTheWholeOfWhatADamperDoesNotCarry) {
    const std::vector<std::complex<double>> psd = friction_distortion(two_velocities(), 1.0);
    // F²(1 − 2/π) in all. A square wave of 8 Hz has 8/(π²n²) of F² at its odd harmonics n; those above 120 Hz (n = 17,
    // 19 …; 15 is at the edge) hold Σ 8/(π²n²) = 0.0253 of F², 7.0 % of the whole. The phase of a random velocity
    // wanders, which spreads the harmonics across the edge: that moves at most half of the two beside it (n = 15, 17),
    // 0.9 % of the whole.
    EXPECT_NEAR(band_power(psd, 0, 0.0, 121.0) / (1.0 - 2.0 / std::numbers::pi), 0.93, 0.01);
    for (std::size_t k = 0; k < kVelocityLines; ++k) {
        EXPECT_LE(std::abs(psd[4 * k + 1]), std::sqrt(std::abs(psd[4 * k].real() * psd[4 * k + 3].real())) + 1e-9)
            << "coherence";
    }
}

/// Each pair is computed in one order; the other order gives the same.
TEST(FrictionDistortion, ElementsMayChangePlaces) {
    VelocitySpectra swapped = two_velocities();
    for (std::size_t k = 0; k < kVelocityLines; ++k) std::swap(swapped.values[4 * k + 1], swapped.values[4 * k + 2]);
    const std::vector<std::complex<double>> psd = friction_distortion(two_velocities(), 1.0),
                                            other = friction_distortion(swapped, 1.0);
    double largest = 0.0;
    for (std::size_t k = 0; k < kVelocityLines; ++k) largest = std::max(largest, std::abs(psd[4 * k + 1]));
    for (std::size_t k = 0; k < kVelocityLines; ++k)
        EXPECT_NEAR(std::abs(psd[4 * k + 1] - other[4 * k + 2]), 0.0, 1e-12 * largest);
}

/// The sizes of the velocities do not matter, to rounding: slopes are differences over 1e-7. With variances that
/// another sum had rounded the lag 0 was 1e-8 of the power off, now and then, and fits of friction took three times as
/// long and ended elsewhere.
TEST(FrictionDistortion, IsSmoothToRounding) {
    const std::vector<std::complex<double>> psd = friction_distortion(two_velocities(), 1.0);
    double power = 0.0;
    for (std::size_t k = 0; k < kVelocityLines; ++k) power += psd[4 * k].real() / kVelocityLines;
    for (const double factor : {1.0 + 1e-7, 1.0 + 3e-7, 1.1, 1.7}) {
        VelocitySpectra larger = two_velocities();
        for (std::complex<double>& value : larger.values) value *= factor;
        const std::vector<std::complex<double>> other = friction_distortion(larger, 1.0);
        // asin of lags beside 0 is steep, too: 1/√(1 − ρ²) is a hundred there.
        for (std::size_t k = 0; k < kVelocityLines; ++k)
            EXPECT_NEAR(other[4 * k].real() / power, psd[4 * k].real() / power, 1e-12) << factor << ' ' << k;
    }
}

}  // namespace
}  // namespace railpem::pem

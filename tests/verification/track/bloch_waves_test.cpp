// The receptance of the uniform track from its waves, against condensation of rail elements.

#include "track/rail/bloch_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "ballasted_track.hpp"
#include "tests/unit/track/wei2016_track.hpp"

namespace {

using namespace railpem;
using namespace railpem::track;

constexpr double kPad = 30e6;

/// A point and another one three bays further on: receptance there, and of one at the other.
TEST(BlochWaves, AreTheReceptanceOfTheUniformTrack) {
    for (const TrackParameters& track : {wei2016_track(), ballasted_track()})
        for (const double frequency : {0.5, 5.0, 80.0, 300.0, 700.0, 1500.0})
            for (const double ahead : {0.0, 0.05, 0.3, 0.55}) {
                lanes::Real omega{};
                for (int lane = 0; lane < lanes::width; ++lane)
                    omega[lane] = 2.0 * std::numbers::pi * frequency * (1.0 + 0.1 * lane);
                const double other = 0.21;
                const ExactRail rail = uniform_rail(track, {ahead, 3.0 * track.spacing_m + other}, kPad);
                ExactRailWorkspace workspace(rail);
                const RailReceptance& expected = rail_receptance(rail, omega, workspace);
                const SupportLaw law(track.pads, track.support, omega);
                const BlochWaves waves = bloch_waves(track, kPad, omega, law);
                ASSERT_TRUE(apart(waves));
                const BayPoint one = bay_point(waves, ahead), two = bay_point(waves, other);
                for (int lane = 0; lane < lanes::width; ++lane) {
                    std::complex<double> across = 0.0;
                    // from the pad ahead of `one` two bays on to the pad behind `two`
                    for (std::size_t i = 0; i < 2; ++i)
                        across += waves.excited[i][lane] * one.from_front[i][lane] *
                                  std::pow(waves.factor[i][lane], 2) * two.from_rear[i][lane];
                    const std::complex<double> own = expected.at(0, 0)[lane], between = expected.at(0, 1)[lane];
                    // Two ways through the same elements: rounding, more of it where the waves are nearly alike (λ to
                    // 1e-3).
                    EXPECT_NEAR(std::abs(one.own[lane] - own), 0.0, 1e-10 * std::abs(own)) << frequency << " " << ahead;
                    EXPECT_NEAR(std::abs(across - between), 0.0, 1e-10 * std::abs(own)) << frequency << " " << ahead;
                }
            }
}

/// The change of a seat as a fraction is the difference of its stiffnesses.
TEST(SupportLaw, ChangeIsTheDifferenceOfStiffnesses) {
    const TrackParameters track = ballasted_track();
    const lanes::Real omega = lanes::broadcast(500.0);
    const SupportLaw law(track.pads, track.support, omega);
    const SupportLaw::Change change = law.change_from(kPad);
    for (const double stiffness : {0.0, 20e6, 31e6, 60e6})
        for (const double scale : {0.0, 0.3, 1.0}) {
            const std::complex<double> expected = (law.stiffness(stiffness, scale) - law.stiffness(kPad))[0];
            const std::complex<double> found =
                change.numerator(stiffness, scale)[0] / change.denominator(stiffness, scale)[0];
            EXPECT_NEAR(std::abs(found - expected), 0.0, 1e-13 * kPad) << stiffness << " " << scale;
        }
}

/// Without any loss: just above the resonance of the sleepers between pads and ballast the supports are so stiff that
/// the rail's two decaying waves are real (over rigid points λ = √3 − 2 and 0), further above a conjugate pair. In
/// between they coincide, and the caller has to look elsewhere.
TEST(BlochWaves, SayWhenTheyCoincide) {
    TrackParameters track = wei2016_track();
    track.pads.damping_n_s_per_m = 0.0;
    track.pads.exponent = 0.0;
    track.support = {.model = SupportModel::two_layer, .mass_kg = 150.0, .stiffness_n_per_m = 60e6};
    const auto at = [&](double omega) {
        return bloch_waves(track, kPad, lanes::broadcast(omega),
                           SupportLaw(track.pads, track.support, lanes::broadcast(omega)));
    };
    const auto real = [&](double omega) { return std::abs(at(omega).factor[0][0].imag()) < 1e-12; };
    const double resonance = std::sqrt((kPad + track.support.stiffness_n_per_m) / track.support.mass_kg);
    double low = 1.0001 * resonance, high = 1.1 * resonance;
    ASSERT_TRUE(real(low));
    ASSERT_FALSE(real(high));
    EXPECT_TRUE(apart(at(low)));
    EXPECT_TRUE(apart(at(high)));
    while (high - low > 1e-13 * resonance) (real(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    EXPECT_FALSE(apart(at(low)));
}

}  // namespace

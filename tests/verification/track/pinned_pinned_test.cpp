// The first pinned–pinned frequency: half a wave of the rail fits between two supports, which then stand in its nodes.
// On a track of equal, undamped point supports that wave exists whatever the supports are made of, so its frequency is
// that of one bay simply supported, in closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "track/rail/decay_rate.hpp"
#include "track/rail/exact_rail.hpp"

namespace railpem::track {
namespace {

constexpr double kSpacing = 0.6;

TrackParameters uic60_track(Beam beam) {
    TrackParameters track;
    track.rail = {.beam = beam,
                  .youngs_modulus_pa = 210e9,
                  .second_moment_of_area_m4 = 3038.3e-8,
                  .mass_kg_per_m = 60.2,
                  .shear_modulus_pa = 81e9,
                  .shear_coefficient = 0.4,
                  .cross_section_m2 = 60.2 / 7850.0};
    track.pads.static_stiffness_n_per_m = 300e6;
    track.support = {.model = SupportModel::two_layer, .mass_kg = 162.0, .stiffness_n_per_m = 50e6};
    track.spacing_m = kSpacing;
    return track;
}

/// Lowest frequency of one bay simply supported, Hz. Euler: (π/2L²)·√(EI/m). Timoshenko: with k = π/L the lower root of
/// (Bk² + S − ω²ρI)(Sk² − ω²m) = S²k² (Timoshenko 1921; the simply supported beam has pure sines as modes).
double pinned_pinned_hz(const RailParameters& rail, double loss = 0.0) {
    const double k2 = std::pow(std::numbers::pi / kSpacing, 2);
    const double m = rail.mass_kg_per_m;
    const double b = rail.youngs_modulus_pa * rail.second_moment_of_area_m4 * (1.0 + loss);
    if (rail.beam == Beam::euler) return 0.5 / std::numbers::pi * k2 * std::sqrt(b / m);
    const double s = rail.shear_coefficient * rail.shear_modulus_pa * rail.cross_section_m2;
    const double rotary = m * rail.second_moment_of_area_m4 / rail.cross_section_m2;
    // In x = ω²: ρI·m·x² − (m(Bk² + S) + ρI·S·k²)·x + B·S·k⁴ = 0
    const double half = 0.5 * (m * (b * k2 + s) + rotary * s * k2);
    const double x = b * s * k2 * k2 / (half + std::sqrt(half * half - rotary * m * b * s * k2 * k2));
    return std::sqrt(x) * 0.5 / std::numbers::pi;
}

std::complex<double> mid_bay(const ExactRail& rail, ExactRailWorkspace& workspace, double frequency) {
    return rail_receptance(rail, lanes::broadcast(2.0 * std::numbers::pi * frequency), workspace).at(0, 0)[0];
}

/// Frequency and height of the largest |receptance| between two frequencies, on a grid of `step`.
std::pair<double, double> peak(const TrackParameters& track, double stiffness, double from, double to, double step) {
    const ExactRail rail = uniform_rail(track, {0.5 * kSpacing}, stiffness);
    ExactRailWorkspace workspace(rail);
    std::pair<double, double> best{0.0, 0.0};
    for (double f = from; f <= to; f += step)
        if (const double size = std::abs(mid_bay(rail, workspace, f)); size > best.second) best = {f, size};
    return best;
}

class PinnedPinned : public testing::TestWithParam<Beam> {};
INSTANTIATE_TEST_SUITE_P(Beams, PinnedPinned, testing::Values(Beam::euler, Beam::timoshenko));

/// At the edge of the stop band a wave's factor per bay is −1 exactly. Near it λ + 1 falls with the root of the
/// distance in frequency, so rounding of 1e-13 in the frequency and the coefficients shows as some 1e-6 here.
TEST_P(PinnedPinned, WaveOfFactorMinusOneWhateverTheSupports) {
    const TrackParameters track = uic60_track(GetParam());
    const double f = pinned_pinned_hz(track.rail);
    for (const double stiffness : {20e6, 300e6, 2e9}) {
        const ExactRail rail = uniform_rail(track, {0.0}, stiffness);
        const auto nearest = [&](double frequency) {
            const HalfTrack half = uniform_half_track(rail, lanes::broadcast(2.0 * std::numbers::pi * frequency));
            return std::min(std::abs(half.factor_1[0] + 1.0), std::abs(half.factor_2[0] + 1.0));
        };
        EXPECT_LT(nearest(f), 1e-5) << stiffness;
        // And nowhere near it a per cent away, where the wave is half a per cent longer or shorter: π·0.005, less in
        // the stop band.
        EXPECT_GT(nearest(0.99 * f), 5e-3) << stiffness;
        EXPECT_GT(nearest(1.01 * f), 5e-3) << stiffness;
    }
}

/// The receptance in the middle of a bay has its peak there; a loss factor of 1e-4 leaves it finite and moves it by
/// about as much. The grid of 1e-4 of the frequency decides the rest.
TEST_P(PinnedPinned, PeakInTheMiddleOfABay) {
    TrackParameters track = uic60_track(GetParam());
    track.rail.loss_factor = 1e-4;
    const double f = pinned_pinned_hz(track.rail);
    EXPECT_NEAR(peak(track, 300e6, 0.97 * f, 1.03 * f, 1e-4 * f).first / f, 1.0, 3e-4);
}

/// With the losses of the shipped case (rail 0.02, pad 0.25, ballast 1.0) the peak is where it was within half the
/// bandwidth η·f of the wave, and higher than over a pad by far.
TEST(PinnedPinnedOfTheShippedTrack, StandsOutInTheMiddleOfABayOnly) {
    TrackParameters track = uic60_track(Beam::timoshenko);
    track.rail.loss_factor = 0.02;
    track.pads.loss_factor = 0.25;
    track.pads.loss_law = LossLaw::constant;
    track.support.loss_factor = 1.0;
    const double f = pinned_pinned_hz(track.rail);
    const auto [frequency, height] = peak(track, 300e6, 0.8 * f, 1.2 * f, 1e-3 * f);
    EXPECT_NEAR(frequency / f, 1.0, 0.01);
    const ExactRail over = uniform_rail(track, {0.0}, 300e6);
    ExactRailWorkspace workspace(over);
    EXPECT_GT(height, 5.0 * std::abs(mid_bay(over, workspace, frequency)));
}

/// The dip of the decay rate around that frequency: the far-reaching wave hardly feels pads and ballast and decays with
/// the rail's own loss alone, while half an octave away it is damped by the pads, too.
TEST(PinnedPinnedOfTheShippedTrack, DampingBelongsToTheRailThere) {
    TrackParameters track = uic60_track(Beam::timoshenko);
    track.pads.loss_factor = 0.25;
    track.pads.loss_law = LossLaw::constant;
    track.support.loss_factor = 1.0;
    const double f = pinned_pinned_hz(track.rail);
    const ExactRail rail = uniform_rail(track, {0.0}, 300e6);
    const auto decay = [&](double frequency) {
        const HalfTrack half = uniform_half_track(rail, lanes::broadcast(2.0 * std::numbers::pi * frequency));
        return bloch_decay_rate_db_per_m(half.factor_1[0], half.factor_2[0], kSpacing);
    };
    // Loss-free rail: what is left is the pads' damping, which vanishes exactly where the supports are nodes.
    EXPECT_LT(decay(f), 1e-3);
    EXPECT_GT(decay(f * 0.85), 0.1);
}

}  // namespace
}  // namespace railpem::track

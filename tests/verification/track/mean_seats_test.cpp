// Seats that stand for failed ones, against the mean over draws of rails with every failed seat in it.

#include "track/rail/mean_seats.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "../pem/paper_case.hpp"
#include "track/rail/exact_rail.hpp"

namespace {

using namespace railpem;
using Complex = std::complex<double>;

constexpr double kShare = 0.05, kLeft = 0.2, kSoundPad = 1.4 * 37.38e6;
constexpr int kSeats = 61;

track::TrackParameters failed_track(double loss) {
    track::TrackParameters track = tests::paper_case(1).track;
    track.pads.loss_factor = loss;
    track.failed_fasteners = {{.fraction = kShare, .remaining_stiffness_fraction = kLeft}};
    return track;
}

/// Mean receptance mid-bay over draws, 61 seats drawn and sound ones beyond; each draw by elimination over all of them.
Complex drawn(const track::TrackParameters& track, double frequency, int draws) {
    Complex sum = 0.0;
    for (int draw = 0; draw < draws; ++draw) {
        track::TrackParameters own = track;
        own.failed_fasteners.front().seed = draw + 1;
        track::StaticEquilibrium equilibrium;
        for (int seat = -kSeats / 2; seat <= kSeats / 2; ++seat) equilibrium.position_m.push_back(seat * own.spacing_m);
        equilibrium.dynamic_stiffness_n_per_m.assign(equilibrium.position_m.size(), kSoundPad);
        equilibrium.unloaded_dynamic_stiffness_n_per_m = kSoundPad;
        const track::ExactRail rail = track::exact_rail(own, {0.5 * own.spacing_m}, equilibrium);
        track::ExactRailWorkspace workspace(rail);
        sum +=
            track::rail_receptance(rail, lanes::broadcast(2.0 * std::numbers::pi * frequency), workspace).at(0, 0)[0] /
            double(draws);
    }
    return sum;
}

Complex equal(track::TrackParameters track, double frequency, const lanes::FactorCurve& factor, double ratio) {
    track.failed_fasteners.clear();
    track.pads.damping_n_s_per_m *= ratio;
    const track::ExactRail rail = track::uniform_rail(track, {0.5 * track.spacing_m}, kSoundPad * ratio,
                                                      {.rail = {}, .pads = factor, .support = {}});
    track::ExactRailWorkspace workspace(rail);
    return track::rail_receptance(rail, lanes::broadcast(2.0 * std::numbers::pi * frequency), workspace).at(0, 0)[0];
}

}  // namespace

// One seat in twenty with a fifth left, 4000 draws. Measured: 0.1, 0.3 and 0.4 % off at 40, 100 and 160 Hz, where the
// mean of the stiffness is 1.6, 2.3 and 2.3 % off; on pads of loss factor 0.25, which resonate at 160 Hz, 0.1, 0.4
// and 3.8 % instead of 1.7, 2.9 and 6.9 %. With 15 % failed it is 0.7 to 7 %, and at the resonance no better than the
// mean: seats that fail side by side count.
TEST(MeanSeats, AgainstDraws) {
    const double mean = 1.0 - kShare * (1.0 - kLeft);
    for (const double loss : {0.0, 0.25}) {
        const track::TrackParameters track = failed_track(loss);
        const lanes::FactorCurve factor = track::mean_of_failed(track, kSoundPad);
        for (const double f : {40.0, 100.0, 160.0}) {
            const Complex seen = drawn(track, f, 4000);
            const double own = std::abs(equal(track, f, factor, 1.0) / seen - 1.0),
                         of_mean_stiffness = std::abs(equal(track, f, {}, mean) / seen - 1.0);
            const bool resonant = loss > 0.0 && f > 150.0;
            EXPECT_LT(own, resonant ? 0.05 : 0.006) << loss << ", " << f << " Hz";
            EXPECT_LT(own, (resonant ? 0.6 : 0.2) * of_mean_stiffness) << loss << ", " << f << " Hz";
        }
    }
}

// Constant loss factors and the laws that stand for them in time.

#include "track/causal_losses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "track/pads/support_law.hpp"

namespace railpem::track {
namespace {

TrackParameters lossy() {
    TrackParameters track;
    track.rail.loss_factor = 0.02;
    track.pads.loss_factor = 0.25;
    track.pads.loss_law = LossLaw::constant;
    track.support = {.model = SupportModel::two_layer, .mass_kg = 162.0, .stiffness_n_per_m = 5e7, .loss_factor = 0.4};
    return track;
}

TEST(CausalLosses, BallastDissipatesTheSameAtItsResonance) {
    const TrackParameters constant = lossy(), causal = causal_losses(constant);
    EXPECT_EQ(causal.support.loss_factor, 0.0);
    const double resonance = std::sqrt(5e7 / 162.0) / (2.0 * std::numbers::pi);
    EXPECT_NEAR(std::abs(support_receptance(causal.support, resonance, {}) -
                         support_receptance(constant.support, resonance, {})),
                0.0, 1e-15);
}

TEST(CausalLosses, ReplaceEveryConstantLossAndNothingElse) {
    const TrackParameters causal = causal_losses(lossy());
    EXPECT_EQ(causal.pads.loss_law, LossLaw::causal);
    EXPECT_EQ(causal.rail.loss_reference_hz, kRailLossHz);
    EXPECT_TRUE(constant_losses(causal).empty());
    EXPECT_EQ(constant_losses(lossy()).size(), 3u);
    EXPECT_TRUE(constant_losses(TrackParameters{}).empty());
}

}  // namespace
}  // namespace railpem::track

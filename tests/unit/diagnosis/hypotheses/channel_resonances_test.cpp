#include "diagnosis/hypotheses/proposers/channel_resonances.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/search/name_physics.hpp"
#include "pem/response_names.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr double kBin_hz = 0.5;

/// Records of two speeds in which the sensor of the front bogie resonates on its mounting.
Synthesised resonant_bogie(double frequency_hz, double damping_ratio) {
    Synthesised made = synthesised(paper_believed({"vehicle.bogie_mass_kg", "vehicle.primary.stiffness_n_per_m"}),
                                   {20.0, 30.0}, 60.0, {"bogie_1", "bogie_2", "wheel_1", "wheel_2"},
                                   {.window_s = 1.0 / kBin_hz, .low_hz = 4.0, .high_hz = 80.0});
    made.truth.effects = {{.effect = "sensor-resonance",
                           .values = {{"frequency_hz", frequency_hz}, {"damping_ratio", damping_ratio}},
                           .choices = {{"channel", "bogie_1"}}}};
    made.draw(5);
    return made;
}

// A window spreads a peak over its main lobe, two bins to either side, and lowers it: what is read off is no sharper
// than that.
TEST(ChannelResonances, AreReadOffWithinTheWindow) {
    for (const double frequency : {23.1, 46.7, 63.6}) {
        const Synthesised made = resonant_bogie(frequency, 0.02);
        const LikelihoodContext context = made.context();
        const Trial trial = believed_trial(made.believed, made.shapes);
        const Fit believed{.trial = trial, .predictions = predict(trial, context)};
        const auto found = channel_resonance(believed, context, pem::response_index("bogie_1"));
        ASSERT_TRUE(found.has_value()) << frequency;
        EXPECT_NEAR(found->frequency_hz, frequency, 2.0 * kBin_hz);
        EXPECT_GE(found->damping_ratio, 0.5 * 0.02);
        EXPECT_LE(found->damping_ratio, 0.02 + 2.0 * kBin_hz / frequency);
        EXPECT_FALSE(channel_resonance(believed, context, pem::response_index("body")).has_value())
            << "nobody has recorded it";
    }
}

TEST(ChannelResonances, SoundChannelsHaveNone) {
    Synthesised made = resonant_bogie(46.7, 0.02);
    made.truth.effects.clear();
    made.draw(6);
    const LikelihoodContext context = made.context();
    const Trial trial = believed_trial(made.believed, made.shapes);
    const Fit believed{.trial = trial, .predictions = predict(trial, context)};
    for (const char* channel : {"bogie_1", "bogie_2", "wheel_1", "wheel_2"})
        EXPECT_FALSE(channel_resonance(believed, context, pem::response_index(channel)).has_value()) << channel;
}

// Between two points of the catalogue's grid, and sharper than it looks for: marched such a record was `unexplained`,
// with a mass on the bogie.
TEST(ChannelResonances, ASharpOneIsNamed) {
    const Synthesised made = resonant_bogie(63.55, 0.0124);
    const NamingResult found = name_physics(made.believed, made.context(Part::fitted, 2), NamingOptions{});
    ASSERT_FALSE(found.sets.empty());
    const auto best = std::max_element(found.sets.begin(), found.sets.end(),
                                       [](const FittedSet& a, const FittedSet& b) { return a.score() < b.score(); });
    ASSERT_EQ(best->fit.trial.effects.size(), 1U);
    EXPECT_EQ(best->fit.trial.effects[0].effect, "sensor-resonance");
    EXPECT_NEAR(best->fit.trial.effects[0].values.at("frequency_hz"), 63.55, 0.01);
}

}  // namespace
}  // namespace railpem::diagnosis

#include "diagnosis/hypotheses/proposers/channel_delays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/search/name_physics.hpp"
#include "pem/response_names.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

/// Records of two speeds in which the sensor of the front bogie is late.
Synthesised late_bogie(double delay_s) {
    Synthesised made =
        synthesised(paper_believed({"vehicle.bogie_mass_kg", "vehicle.primary.stiffness_n_per_m"}), {20.0, 30.0}, 60.0,
                    {"bogie_1", "bogie_2", "wheel_1", "wheel_2"}, {.window_s = 2.0, .low_hz = 4.0, .high_hz = 80.0});
    made.truth.effects = {
        {.effect = "timing-skew", .values = {{"delay_s", delay_s}}, .choices = {{"channel", "bogie_1"}}}};
    made.draw(3);
    return made;
}

// The step is an eighth of the shortest period, 1.56 ms. A tenth of a second is a twentieth of the window.
TEST(ChannelDelays, AreFoundToAStep) {
    for (const double delay : {-0.0165, 0.0, 0.004, 0.1, -0.4}) {
        const Synthesised made = late_bogie(delay);
        const LikelihoodContext context = made.context();
        const Trial trial = believed_trial(made.believed, made.shapes);
        const Fit believed{.trial = trial, .predictions = predict(trial, context)};
        EXPECT_NEAR(channel_delay_s(believed, context, pem::response_index("bogie_1"), 1.0), delay, 1.0 / (8.0 * 80.0))
            << delay;
        EXPECT_EQ(channel_delay_s(believed, context, pem::response_index("body"), 1.0), 0.0)
            << "nobody has recorded it";
    }
}

// One full turn of phase at 60 Hz: a derivative at nothing sees noise and another gain. Marched such a record was
// `unexplained`.
TEST(ChannelDelays, AChannelThatIsFarTooLateIsNamed) {
    const Synthesised made = late_bogie(-0.0165);
    const NamingResult found = name_physics(made.believed, made.context(Part::fitted, 2), NamingOptions{});
    ASSERT_FALSE(found.sets.empty());
    const auto best = std::max_element(found.sets.begin(), found.sets.end(),
                                       [](const FittedSet& a, const FittedSet& b) { return a.score() < b.score(); });
    ASSERT_EQ(best->fit.trial.effects.size(), 1U);
    EXPECT_EQ(best->fit.trial.effects[0].effect, "timing-skew");
    EXPECT_NEAR(best->fit.trial.effects[0].values.at("delay_s"), -0.0165, 1e-5);
}

}  // namespace
}  // namespace railpem::diagnosis

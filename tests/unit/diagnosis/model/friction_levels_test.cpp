#include "diagnosis/model/friction_levels.hpp"

#include <gtest/gtest.h>

#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr double kTwice_db = 6.020599913279624;

Synthesised slow_and_fast() {
    return synthesised(paper_believed({}), {15.0, 33.0}, 20.0, {"wheel_1"}, kSmall);
}

std::vector<FrictionLevel> levels_of(const Synthesised& made, const Trial& trial) {
    return friction_levels(trial, made.believed, made.shapes);
}

// So little friction changes nothing, and velocities go with the irregularity.
TEST(FrictionLevels, AreVelocitiesThatDoubleWithTheIrregularity) {
    const Synthesised made = slow_and_fast();
    Trial trial = believed_trial(made.believed, made.shapes);
    EXPECT_TRUE(levels_of(made, trial).empty());
    trial.numbers.vehicle.primary.friction_force_n = 1e-6;
    const std::vector<FrictionLevel> once = levels_of(made, trial);
    trial.effects.push_back(
        {.effect = "irregularity-spectrum", .values = {{"level_db", kTwice_db}, {"slope_db_per_octave", 0.0}}});
    const std::vector<FrictionLevel> twice = levels_of(made, trial);
    ASSERT_EQ(once.size(), 1u);
    ASSERT_EQ(twice.size(), 1u);
    EXPECT_EQ(once[0].stage, Element::primary);
    EXPECT_LT(once[0].slowest_m_per_s, once[0].fastest_m_per_s);
    EXPECT_NEAR(twice[0].slowest_m_per_s, 2.0 * once[0].slowest_m_per_s, 1e-6 * once[0].slowest_m_per_s);
    EXPECT_NEAR(twice[0].fastest_m_per_s, 2.0 * once[0].fastest_m_per_s, 1e-6 * once[0].fastest_m_per_s);
}

TEST(FrictionLevels, SayWhere) {
    const Synthesised made = slow_and_fast();
    Trial trial = believed_trial(made.believed, made.shapes);
    trial.numbers.vehicle.secondary.friction_force_n = 500.0;
    const std::vector<std::string> said = said_of_friction(levels_of(made, trial));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].find("the friction of the secondary suspension is known at velocities of "), 0u) << said[0];
}

}  // namespace
}  // namespace railpem::diagnosis

#include "diagnosis/model/wheel_unloading.hpp"

#include <gtest/gtest.h>

#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

/// Records of which the wheels say so much of their contact forces.
std::vector<Observation> records(const std::vector<double>& variations) {
    const std::vector<double> speeds(variations.size(), 20.0);
    std::vector<Observation> made = synthesised(paper_believed({}), speeds, 20.0, {"wheel_1"}, kSmall).shapes;
    for (std::size_t i = 0; i < made.size(); ++i)
        made[i].name = "run " + std::to_string(i), made[i].expectation.contacts.force_variation = variations[i];
    return made;
}

TEST(WheelUnloading, ARunInWhichWheelsLeaveTheRailIsLeftOut) {
    std::vector<Observation> observations = records({0.12, 0.70, 0.21});
    const std::vector<std::string> said = leave_out_unloaded(observations);
    ASSERT_EQ(observations.size(), 2u);
    EXPECT_EQ(observations[0].name, "run 0");
    EXPECT_EQ(observations[1].name, "run 2");
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said.front().find("run 1: left out: the contact forces vary by 70 %"), 0u) << said.front();
}

// There is nothing else to go by, and the remark about unloading stands beside what is found.
TEST(WheelUnloading, TheOnlyRunsStay) {
    std::vector<Observation> observations = records({0.70, 0.40});
    EXPECT_TRUE(leave_out_unloaded(observations).empty());
    EXPECT_EQ(observations.size(), 2u);
}

}  // namespace
}  // namespace railpem::diagnosis

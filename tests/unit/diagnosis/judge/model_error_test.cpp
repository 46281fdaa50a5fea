#include "diagnosis/judge/model_error.hpp"

#include <gtest/gtest.h>

namespace railpem::diagnosis {
namespace {

FittedSet set_of(const std::string& effect, const std::map<std::string, std::string>& choices,
                 const std::vector<std::string>& released) {
    FittedSet set{.released = released};
    if (!effect.empty()) set.effects.push_back({.instance = {.effect = effect, .values = {}, .choices = choices}});
    return set;
}

// What is looked for from afar once more: marched, ballast, the second of two effects and preloaded pads stood beside a
// number that was not wrong.
TEST(IsDoubtful, AnEffectOfStructureThatNeedsAWrongNumber) {
    EXPECT_TRUE(is_doubtful(set_of("support-compliance", {}, {"track.rail.mass_kg_per_m"})));
    EXPECT_FALSE(is_doubtful(set_of("support-compliance", {}, {})));
    EXPECT_FALSE(is_doubtful(set_of("", {}, {"track.rail.mass_kg_per_m"}))) << "a number may be wrong by itself";
    EXPECT_FALSE(is_doubtful(set_of("sensor-gain", {{"channel", "bogie_1"}}, {"track.rail.mass_kg_per_m"})))
        << "a sensor has no lower hills";
}

}  // namespace
}  // namespace railpem::diagnosis

#include "app/schema/nearest_key.hpp"

#include <gtest/gtest.h>

namespace railpem::app {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
    EXPECT_EQ(edit_distance("", "abc"), 3u);
    EXPECT_EQ(edit_distance("abc", "abc"), 0u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);  // Levenshtein's own example
    EXPECT_EQ(edit_distance("rial", "rail"), 1u);       // a swap, two edits without it
    EXPECT_EQ(edit_distance("ca", "abc"), 3u);          // optimal string alignment, 2 in the unrestricted distance
}

TEST(WithoutUnit, TakesOffEveryUnitWordAtTheEnd) {
    EXPECT_EQ(without_unit("body_pitch_inertia_kg_m2"), "body_pitch_inertia");
    EXPECT_EQ(without_unit("damping_n_s_per_m"), "damping");
    EXPECT_EQ(without_unit("constant_m_per_n23"), "constant");
    EXPECT_EQ(without_unit("shape_at_pivots"), "shape_at_pivots");
    EXPECT_EQ(without_unit("m"), "m");
}

TEST(NearestKey, PrefersTheSameNameWithAnotherUnit) {
    // By edits alone body_mass_kg would lose to the shorter body_mess.
    const std::vector<std::string> known{"body_mess", "body_mass_kg", "bogie_mass_kg"};
    EXPECT_EQ(nearest_key("body_mass", known), "body_mass_kg");
    EXPECT_EQ(nearest_key("body_mass_t", known), "body_mass_kg");
}

TEST(NearestKey, IsEmptyWhenNothingIsNear) {
    EXPECT_EQ(nearest_key("colour", {"body_mass_kg", "wheelbase_m"}), "");
    EXPECT_EQ(nearest_key("x", {}), "");
}

}  // namespace
}  // namespace railpem::app

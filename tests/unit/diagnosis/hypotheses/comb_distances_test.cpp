// Distances between dips found by their lines.

#include "diagnosis/hypotheses/proposers/comb_distances.hpp"

#include <gtest/gtest.h>

#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

/// The believed case as it stands, seen against records of two speeds that were drawn from the truth.
struct Seen {
    Synthesised made;
    Fit fit;
};

Seen seen(const std::vector<EffectInstance>& hidden, std::uint64_t seed) {
    Seen own{.made = synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {15.0, 22.0}, 60.0,
                                 {"bogie_1", "wheel_1", "wheel_2"}, kFine),
             .fit = {}};
    own.fit.trial = own.made.truth;
    own.made.truth.effects = hidden;
    own.made.draw(seed);
    own.fit.predictions = predict(own.fit.trial, own.made.context());
    return own;
}

EffectInstance dips_every(double spacing_m) {
    return {.effect = "rail-joints",
            .values = {{"spacing_m", spacing_m}, {"depth_m", 1e-3}, {"length_m", 0.5}},
            .choices = {}};
}

// Dips of 1 mm. A window of 4 s tells lines of 40 Hz, the highest that a dip of 0.5 m has at 22 m/s, to a quarter of a
// hertz, 0.6 %: the sum over many lines is asked to be within a third of that.
TEST(CombDistances, FindsTheDistanceOfJoints) {
    for (const double spacing : {6.3, 13.7, 25.0}) {
        const Seen own = seen({dips_every(spacing)}, 1);
        const std::vector<CombDistance> found = comb_distances(own.fit, own.made.context(), 5.0, 44.0, 4);
        ASSERT_FALSE(found.empty());
        EXPECT_NEAR(found.front().spacing_m / spacing, 1.0, 2e-3);
        EXPECT_GT(found.front().nats, 30.0);
    }
}

// Of some 3000 combs, 500 of them independent, the best of a record without joints reaches ½·z² with z the largest of
// 500 normal deviates, 3.1 on average and below 4.5 in all but 2 records of 1000.
TEST(CombDistances, PromisesLittleWhereThereAreNone) {
    for (const std::uint64_t seed : {2U, 3U, 4U}) {
        const Seen own = seen({}, seed);
        const std::vector<CombDistance> found = comb_distances(own.fit, own.made.context(), 5.0, 44.0, 1);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_LT(found.front().nats, 0.5 * 4.5 * 4.5);
    }
}

TEST(CombDistances, KeepsApartWhatItReturns) {
    const Seen own = seen({dips_every(13.7)}, 1);
    const std::vector<CombDistance> found = comb_distances(own.fit, own.made.context(), 5.0, 44.0, 5);
    ASSERT_EQ(found.size(), 5U);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GT(std::abs(found[i].spacing_m / found[j].spacing_m - 1.0), 0.019);
            EXPECT_LE(found[i].nats, found[j].nats);
        }
}

// Candidates that have a distance get companions, others none.
TEST(CombDistances, CompanionsForCombsAlone) {
    const Seen own = seen({dips_every(13.7)}, 1);
    std::vector<Candidate> list = candidates(own.made.believed, own.fit.trial, own.made.observations).candidates;
    const std::size_t before = list.size();
    add_combs(own.fit, own.made.context(), list);
    ASSERT_EQ(list.size(), before + 4);
    for (std::size_t i = before; i < list.size(); ++i) EXPECT_EQ(list[i].instance.effect, "rail-joints");
    EXPECT_NEAR(list[before].instance.values.at("spacing_m") / 13.7, 1.0, 2e-3);
    EXPECT_EQ(list[before].instance.values.at("spacing_m"), list[before].probe.values.at("spacing_m"));
}

}  // namespace
}  // namespace railpem::diagnosis

// Beliefs that sets give up, held against cases that keep them, with evidences that are given.

#include "diagnosis/judge/verdict.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "tests/unit/diagnosis/given_sets.hpp"

namespace railpem::diagnosis {
namespace {

// Of a track 8 dB smoother the unseen part was 1.9 nats less probable than after retuning, which had gone there, too,
// and it was `explained`: the rival is the case that keeps its beliefs.
TEST(WeighedAlready, AreBeliefsThatRetuningHasLeft) {
    const auto asks = [](const FittedSet& set, double unseen_share = 1.0 / 3.0) {
        NamingResult naming = given_naming({set});
        naming.unseen_share = unseen_share;
        return is_weighed_already(naming.sets.front(), naming, thresholds);
    };
    EXPECT_TRUE(asks(given_set({"irregularity-spectrum"}, {"vehicle.bogie_mass_kg"}, 20.0, -1.9)));
    EXPECT_TRUE(asks(given_set({"sleeper-passing"}, {}, 1.6, 1.9)));
    EXPECT_FALSE(asks(given_set({"sleeper-passing"}, {}, 20.0, 2.1))) << "retuning did not get there";
    EXPECT_FALSE(asks(given_set({"sleeper-passing"}, {}, 1.4, 0.0))) << "no name comes of it";
    EXPECT_FALSE(asks(given_set({"rail-shear"}, {"vehicle.bogie_mass_kg"}, 20.0, 0.0))) << "physics";
    EXPECT_FALSE(asks(given_set({"irregularity-spectrum"}, {}, 20.0, 0.0), 0.0)) << "nothing is unseen";
}

TEST(OutdoesKept, AsksForTheSeenBeyondChanceAndForTheUnseen) {
    const auto outdoes = [](double seen, double unseen) {
        FittedSet set = given_set({"irregularity-spectrum"}, {}, 20.0, unseen);
        set.fit.log_likelihood = seen;
        return outdoes_kept(set, given_set({}, {}, 0.0, 0.0));
    };
    EXPECT_TRUE(outdoes(2.1, 0.1));
    EXPECT_FALSE(outdoes(1.9, 0.1)) << "the case that keeps its belief explains as much";
    EXPECT_FALSE(outdoes(90.0, -0.1));
}

/// The case that keeps what a set gives up explains as much as it but for so many nats, seen and unseen.
std::optional<FittedSet> behind(const FittedSet& set, double nats) {
    FittedSet kept = given_set({}, {}, 0.0, set.held_out - nats);
    kept.fit.log_likelihood = set.fit.log_likelihood - nats;
    return kept;
}

TEST(UnfoundedBeliefs, AreDroppedAndTheNextIsAsked) {
    NamingResult naming =
        given_naming({given_set({"irregularity-spectrum"}, {}, 20.0, -1.0),
                      given_set({}, {"vehicle.bogie_mass_kg"}, 18.0, 0.5), given_set({"rail-shear"}, {}, 17.0, 5.0)});
    naming.unseen_share = 1.0 / 3.0;
    const HeldBeliefs held = drop_unfounded_beliefs(
        naming, thresholds, [](const FittedSet& set) { return behind(set, set.released.empty() ? -0.1 : 50.0); });
    ASSERT_EQ(naming.sets.size(), 2u);
    EXPECT_EQ(labels_of(naming.sets.front()), std::vector<std::string>{"parameter-error"});
    EXPECT_EQ(held.unfounded, std::vector<std::string>{"irregularity-spectrum"});
    ASSERT_EQ(naming.dropped.size(), 1u);
    EXPECT_EQ(labels_of(naming.dropped.front()), std::vector<std::string>{"irregularity-spectrum"});
    ASSERT_TRUE(held.of_best.has_value());
    EXPECT_EQ(held.of_best->held_out, -49.5) << "of what is best now";
}

TEST(UnfoundedBeliefs, DoNotStandBesideAName) {
    const auto left = [](double score) {
        NamingResult naming = given_naming(
            {given_set({"rail-shear"}, {}, 20.0, 5.0), given_set({"irregularity-spectrum"}, {}, score, 0.0)});
        naming.unseen_share = 1.0 / 3.0;
        const HeldBeliefs held =
            drop_unfounded_beliefs(naming, thresholds, [](const FittedSet&) { return std::nullopt; });
        EXPECT_FALSE(held.of_best.has_value()) << "physics is held against retuning";
        return naming.sets.size();
    };
    EXPECT_EQ(left(18.0), 1u) << "what physics forbids is no case that keeps it";
    EXPECT_EQ(left(15.0), 2u) << "no rival anyhow";
}

TEST(UnfoundedBeliefs, NothingIsAskedOfWhatRetuningDidNotReach) {
    NamingResult naming = given_naming({given_set({}, {"vehicle.bogie_mass_kg"}, 200.0, 60.0)});
    naming.unseen_share = 1.0 / 3.0;
    int asked = 0;
    EXPECT_FALSE(drop_unfounded_beliefs(naming, thresholds, [&](const FittedSet& set) {
                     return ++asked, behind(set, 1.0);
                 }).of_best.has_value());
    EXPECT_EQ(asked, 0);
    EXPECT_EQ(naming.sets.size(), 1u);
}

}  // namespace
}  // namespace railpem::diagnosis

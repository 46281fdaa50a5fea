// The rival of a belief that is given up: recordings drawn from a case with one number four and a half tolerances off.

#include "diagnosis/judge/belief_kept.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/judge/verdict.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

const std::string kWrong = "vehicle.primary.stiffness_n_per_m", kOther = "vehicle.primary.damping_n_s_per_m";
constexpr double kFactor = 1.57;  // 4.5 tolerances

FittedSet giving_up(const std::vector<std::string>& effects, const std::vector<std::string>& released) {
    FittedSet set{.released = released};
    for (const std::string& effect : effects)
        set.effects.push_back({.instance = {.effect = effect, .values = {}, .choices = {}}});
    return set;
}

class BeliefKept : public ::testing::Test {
  protected:
    BeliefKept()
        : made_(synthesised(paper_believed({kWrong, kOther, "vehicle.bogie_mass_kg"}), {22.2}, 60.0, nine_channels(),
                            kSmall)) {
        number_at(made_.truth.numbers, kWrong) *= kFactor;
        made_.draw(7);
        retuned_ = fit_set(made_.believed, {}, {}, {}, {}, made_.context(), {});
        named_ = fit_set(made_.believed, retuned_.fit, {}, {kWrong}, {}, made_.context(), {});
        kept_ = *fit_belief_kept(made_.believed, retuned_.fit, named_, made_.context(), {});
    }

    double log_factor(const Fit& fit, const std::string& key) const {
        std::size_t u = 0;
        fit.find(key, &u);
        return fit.values[u];
    }

    Synthesised made_;
    FittedSet retuned_, named_, kept_;
};

TEST_F(BeliefKept, NoBeliefIsLeftFurtherThanTheSetLeavesIt) {
    EXPECT_NEAR(log_factor(kept_.fit, kWrong), 2.0 * tolerance_of(kWrong), 1e-12) << "as far as it may";
    for (std::size_t u = 0; u < kept_.fit.unknowns.size(); ++u) {
        const Unknown &unknown = kept_.fit.unknowns[u], &own = *retuned_.fit.find(unknown.name);
        if (unknown.kind == UnknownKind::noise || unknown.kind == UnknownKind::floor ||
            unknown.kind == UnknownKind::width || unknown.kind == UnknownKind::speed) {
            EXPECT_EQ(unknown.low, own.low) << unknown.name;
            continue;
        }
        EXPECT_LE(std::abs(kept_.fit.values[u] - unknown.mean), 2.0 * unknown.deviation * (1.0 + 1e-12))
            << unknown.name;
    }
}

TEST_F(BeliefKept, BeliefsAreThoseOfWhatRetuningMoves) {
    const FittedSet smoother = giving_up({"irregularity-spectrum"}, {}), passing = giving_up({"sleeper-passing"}, {}),
                    shear = giving_up({"rail-shear"}, {kOther});
    for (const Unknown& unknown : retuned_.fit.unknowns) {
        EXPECT_EQ(gives_up(smoother, unknown), unknown.kind == UnknownKind::irregularity) << unknown.name;
        EXPECT_EQ(gives_up(passing, unknown), unknown.kind == UnknownKind::passing) << unknown.name;
        EXPECT_EQ(gives_up(shear, unknown), unknown.name == kOther) << unknown.name;
    }
}

TEST_F(BeliefKept, GoesAsFarAsTheSetAndNoFurtherThanPhysics) {
    const Unknown narrow{.kind = UnknownKind::number, .mean = 0.0, .deviation = 1.0, .low = -0.5, .high = 30.0};
    EXPECT_EQ(kept(narrow, 0.0).low, -0.5);
    EXPECT_EQ(kept(narrow, 0.0).high, 2.0);
    EXPECT_EQ(kept(narrow, 1.9).high, 2.0);
    EXPECT_EQ(kept(narrow, 3.5).high, 3.5);
    const Unknown measured{.kind = UnknownKind::irregularity, .mean = 0.7, .deviation = 0.1, .low = -4.0, .high = 4.0};
    EXPECT_NEAR(kept(measured, 0.0).low, 0.5, 1e-12) << "about what was measured";
    EXPECT_NEAR(kept(measured, 0.0).high, 0.9, 1e-12);
}

// A speed, or a number that is off by itself, is no gain of what is named.
TEST_F(BeliefKept, OwesNothingToWhatElseIsFarOff) {
    FittedSet far = named_;
    std::size_t u = 0;
    far.fit.find(kOther, &u);
    far.fit.values[u] = -3.0 * tolerance_of(kOther);
    const FittedSet kept_beside =
        *fit_belief_kept(made_.believed, retuned_.fit, far, made_.context(), {.iterations = 0, .from_far = false});
    EXPECT_NEAR(kept_beside.fit.find(kOther)->low, -3.0 * tolerance_of(kOther), 1e-12);
    EXPECT_NEAR(kept_beside.fit.find(kOther)->high, 3.0 * tolerance_of(kOther), 1e-12);
}

// Retuning that only weighs its beliefs has found the number, and what no fit has seen is as probable after it: of 1
// nat, either way, nobody can tell. The case that keeps the belief tells, and another number, as free, does not make up
// for it.
TEST_F(BeliefKept, TellsWhetherTheBeliefWasWrong) {
    EXPECT_NEAR(std::exp(log_factor(retuned_.fit, kWrong)), kFactor, 0.03);
    EXPECT_NEAR(named_.held_out, retuned_.held_out, 1.0);
    EXPECT_TRUE(outdoes_kept(named_, kept_));
    EXPECT_FALSE(outdoes_kept(kept_, kept_));

    Supposition other = suppose(made_.believed, kept_.fit, {}, {kOther}, {}, made_.context());
    for (Unknown& unknown : other.unknowns)
        if (unknown.name != kOther) unknown = *kept_.fit.find(unknown.name);
    const Fit wrong = fit(other.trial, other.unknowns, other.start, made_.context());
    const double gain = named_.held_out - kept_.held_out,
                 wrong_gain = part_log_likelihood(wrong, made_.context(), Part::held_out) - kept_.held_out;
    std::printf("unseen: %.1f nats by the number that is wrong, %.1f by another\n", gain, wrong_gain);
    EXPECT_GT(gain, 20.0);  // where 1 is chance
    EXPECT_LT(wrong_gain, 0.1 * gain);
}

// Within two tolerances there is nothing that a belief forbids.
TEST_F(BeliefKept, IsRetuningWhereNothingIsFarOff) {
    FittedSet mass = retuned_;  // the stiffness as far off as it is
    mass.released = {"vehicle.bogie_mass_kg"};
    const FittedSet same = *fit_belief_kept(made_.believed, retuned_.fit, mass, made_.context(), {});
    // a fit ends where a step promises 0.1 (FitOptions::least_gain): two ends
    EXPECT_NEAR(same.fit.log_likelihood, retuned_.fit.log_likelihood, 0.2);
    EXPECT_FALSE(outdoes_kept(retuned_, same));
}

}  // namespace
}  // namespace railpem::diagnosis

// The rival of a belief that is given up: recordings drawn from a case with one number four and a half tolerances off.

#include "diagnosis/within_tolerances.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

const std::string kWrong = "vehicle.primary.stiffness_n_per_m", kOther = "vehicle.primary.damping_n_s_per_m";
constexpr double kFactor = 1.57;  // 4.5 tolerances

class WithinTolerances : public ::testing::Test {
  protected:
    WithinTolerances() : made_(synthesised(paper_believed({kWrong, kOther, "vehicle.bogie_mass_kg"}), {22.2}, 60.0, nine_channels(), kSmall)) {
        number_at(made_.truth.numbers, kWrong) *= kFactor;
        made_.draw(7);
        retuned_ = fit_set(made_.believed, {}, {}, {}, {}, made_.context(), {});
        kept_ = fit_within_tolerances(made_.believed, retuned_.fit, made_.context(), {});
    }

    Synthesised made_;
    FittedSet retuned_, kept_;
};

TEST_F(WithinTolerances, NoBeliefIsLeft) {
    for (std::size_t u = 0; u < kept_.fit.unknowns.size(); ++u) {
        const Unknown& unknown = kept_.fit.unknowns[u];
        if (unknown.kind == UnknownKind::noise || unknown.kind == UnknownKind::floor || unknown.kind == UnknownKind::width) continue;  // the recordings' own
        EXPECT_LE(std::abs(kept_.fit.values[u] - unknown.mean), 2.0 * unknown.deviation * (1.0 + 1e-12)) << unknown.name;
    }
    std::size_t u = 0;
    kept_.fit.find(kWrong, &u);
    EXPECT_NEAR(kept_.fit.values[u], 2.0 * tolerance_of(kWrong), 1e-12) << "as far as it may";
}

TEST_F(WithinTolerances, WhatIsNoBeliefStaysAsItIs) {
    const Unknown noise{.kind = UnknownKind::noise, .mean = 0.0, .deviation = 1.0, .low = -30.0, .high = 3.0};
    EXPECT_EQ(kept(noise).low, -30.0);
    EXPECT_EQ(kept(noise).high, 3.0);
    const Unknown narrow{.kind = UnknownKind::number, .mean = 0.0, .deviation = 1.0, .low = -0.5, .high = 30.0};
    EXPECT_EQ(kept(narrow).low, -0.5) << "physics is narrower than the belief";
    EXPECT_EQ(kept(narrow).high, 2.0);
}

// Retuning that only weighs its beliefs has found the number, and what no fit has seen is as probable after it: of 1 nat, either way, nobody can tell. The belief costs a case that keeps it much more, and another number, as free,
// does not bring it back.
TEST_F(WithinTolerances, TellsWhetherTheBeliefWasWrong) {
    std::size_t u = 0;
    retuned_.fit.find(kWrong, &u);
    EXPECT_NEAR(std::exp(retuned_.fit.values[u]), kFactor, 0.03);
    const FittedSet named = fit_set(made_.believed, retuned_.fit, {}, {kWrong}, {}, made_.context(), {});
    EXPECT_NEAR(named.held_out, retuned_.held_out, 1.0);
    const double gain = named.held_out - kept_.held_out;
    EXPECT_GT(gain, 20.0);

    Supposition other = suppose(made_.believed, kept_.fit, {}, {kOther}, {}, made_.context());
    for (Unknown& unknown : other.unknowns)
        if (unknown.name != kOther) unknown = kept(std::move(unknown));
    const Fit wrong = fit(other.trial, other.unknowns, other.start, made_.context());
    const double wrong_gain = part_log_likelihood(wrong, made_.context(), Part::held_out) - kept_.held_out;
    std::printf("unseen: %.1f nats by the number that is wrong, %.1f by another\n", gain, wrong_gain);
    EXPECT_LT(wrong_gain, 0.1 * gain);
}

}  // namespace
}  // namespace railpem::diagnosis

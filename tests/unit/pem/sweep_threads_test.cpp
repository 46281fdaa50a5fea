// Cases shared out to threads: what each gives does not depend on how many there are, and what one throws reaches the
// caller.

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "pem/lines/sweep.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::pem {
namespace {

constexpr std::size_t kCases = 6;

SweepPlan plan() {
    SweepPlan sweep;
    sweep.base = tests::paper_case(2);
    sweep.base.frequency = {.from_hz = 5.0, .to_hz = 150.0, .step_hz = 5.0};
    sweep.axes = {
        {.key = "track.pads.damping_n_s_per_m",
         .set = [](CaseParameters& parameters, double value) { parameters.track.pads.damping_n_s_per_m = value; },
         .values = {3e4, 4e4, 5e4, 6e4, 7e4, 8e4}}};
    sweep.quantities = {{"wheel_1", QuantityKind::rms}, {"body", QuantityKind::spectrum}};
    return sweep;
}

std::vector<std::vector<double>> rows(int threads) {
    std::vector<std::vector<double>> values(kCases);
    run_sweep(plan(), threads,
              {.finished = [](std::size_t) { return false; },
               .done = [&](std::size_t index, const std::vector<double>& row) { values[index] = row; }});
    return values;
}

TEST(SweepThreads, TheSameBitsForAnyNumber) {
    const std::vector<std::vector<double>> alone = rows(1);
    for (const std::vector<double>& row : alone) ASSERT_EQ(row.size(), sweep_rows(plan()).size());
    EXPECT_NE(alone.front(), alone.back());
    EXPECT_EQ(rows(4), alone);           // each case on one thread
    EXPECT_EQ(rows(kCases + 2), alone);  // fewer cases than threads: the lines of each are shared out
}

TEST(SweepThreads, WhatOneThrowsReachesTheCaller) {
    const auto fail = [](std::size_t index, const std::vector<double>&) {
        if (index == 2) throw std::runtime_error("disk full");
    };
    EXPECT_THROW(run_sweep(plan(), 4, {.finished = [](std::size_t) { return false; }, .done = fail}),
                 std::runtime_error);
}

}  // namespace
}  // namespace railpem::pem

#include "pem/distortion/passing_modulation.hpp"
#include "pem/coupling/excite.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "tests/verification/pem/paper_case.hpp"

namespace railpem::pem {
namespace {

constexpr double kRollingSpeed = 33.0;

struct Passing {
    CaseParameters parameters;
    ModulationTransfers transfers;
    TrackExcitation alone;
};

Passing passing(CaseParameters c) {
    c.solver.moving = true;
    c.frequency = {.from_hz = 1.0, .to_hz = 200.0, .step_hz = 1.0};
    c.sleeper_passing.amplitude_factor =
        c.sleeper_passing.amplitude_factor == 0.0 ? 1.0 : c.sleeper_passing.amplitude_factor;
    const CoupledModel model = coupled_model(c, kRollingSpeed);
    return {c,
            modulation_transfers(c, model, kRollingSpeed,
                                 rolling_table(model, kRollingSpeed, modulation_end_hz(c, kRollingSpeed))),
            track_excitation(c, vehicle::wheel_positions(c.vehicle), kRollingSpeed, &model)};
}

CaseParameters failed_case() {
    CaseParameters c = tests::paper_case(1);
    c.track.failed_fasteners = {{.every = 8, .remaining_stiffness_fraction = 0.1}};
    return c;
}

// The factor is on the lines, for whatever reason they are larger; what the rail gives way is that of the track.
TEST(PassingModulation, AmplitudeOfTheLinesDoesNotCount) {
    CaseParameters c = tests::paper_case(1);
    const Passing plain = passing(c);
    c.sleeper_passing.amplitude_factor = 1.25;
    const Passing louder = passing(c);
    EXPECT_NEAR(std::abs(louder.alone.passing[0].amplitude_m[0] / plain.alone.passing[0].amplitude_m[0]), 1.25, 1e-9);
    const auto a = modulations(plain.parameters, plain.alone, plain.transfers, 0.0),
               b = modulations(louder.parameters, louder.alone, louder.transfers, 0.0);
    ASSERT_EQ(a.size(), b.size());
    ASSERT_FALSE(a.empty());
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            EXPECT_NEAR(std::abs(b[i].under_wheel[wheel] / a[i].under_wheel[wheel] - 1.0), 0.0, 1e-12);
}

// γ(t) is real: the orders of either side are conjugates.
TEST(PassingModulation, SidesAreConjugate) {
    const Passing sound = passing(tests::paper_case(1));
    const auto orders = modulations(sound.parameters, sound.alone, sound.transfers, 0.0);
    for (std::size_t i = 0; i + 1 < orders.size(); i += 2) {
        EXPECT_EQ(orders[i].shift_hz, -orders[i + 1].shift_hz);
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            EXPECT_EQ(orders[i].under_wheel[wheel], std::conj(orders[i + 1].under_wheel[wheel]));
    }
}

// The sweeps are counted, not ended by a tolerance: slopes by differences need a smooth prediction. Eight leave less
// than 3e-4 of the lines up to the first whole bay, which have the power, and 1e-2 of those beyond; six leave 5e-4
// and 1.1 %.
TEST(PassingModulation, LinesHaveSettled) {
    const Passing broken = passing(failed_case());
    TrackExcitation usual = broken.alone, longer = broken.alone;
    feed_back_lines(broken.parameters, broken.transfers, usual);
    feed_back_lines(broken.parameters, broken.transfers, longer, 24);
    double moved = 0.0;
    for (std::size_t line = 0; line < usual.passing.size(); ++line)
        for (std::size_t wheel = 0; wheel < 4; ++wheel) {
            const auto own = longer.passing[line].amplitude_m[wheel];
            moved = std::max(moved, std::abs(own / broken.alone.passing[line].amplitude_m[wheel] - 1.0));
            EXPECT_LT(std::abs(usual.passing[line].amplitude_m[wheel] / own - 1.0), line < 8 ? 3e-4 : 0.01) << line + 1;
        }
    EXPECT_GT(moved, 0.1);
}

}  // namespace
}  // namespace railpem::pem

#include "pem/coupling/rolling_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pem/coupling/wheel_transfers.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::pem {
namespace {

constexpr double kTableSpeed = 22.0, kEnd = 250.0;

CaseParameters rolling_case() {
    CaseParameters c = tests::paper_case(1);
    c.solver.moving = true;
    return c;
}

RollingTable table_of(const CaseParameters& c, const RollingTable* near = nullptr) {
    return rolling_table(coupled_model(c, kTableSpeed), kTableSpeed, kEnd, near);
}

/// The largest difference of two lines.
double apart(const RollingTable& a, const RollingTable& b, std::size_t line) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.at[line].values.size(); ++i)
        largest = std::max(largest, std::abs(a.at[line].values[i] - b.at[line].values[i]));
    return largest;
}

// What a twentieth of the pads' stiffness changes, from every second line: where pads matter least the periodic images
// of the integrals, 1e-5 of the receptance, are 1.8e-3 of the change.
TEST(RollingTable, ChangeIsToldByEverySecondLine) {
    const RollingTable before = table_of(rolling_case());
    CaseParameters stiffer = rolling_case();
    stiffer.track.pads.static_stiffness_n_per_m *= 1.05;
    const RollingTable exact = table_of(stiffer), told = table_of(stiffer, &before);
    ASSERT_EQ(exact.at.size(), told.at.size());
    int between = 0;
    for (std::size_t line = 0; line < exact.at.size(); ++line) {
        EXPECT_LE(apart(told, exact, line), 2e-3 * apart(exact, before, line)) << "line " << line;
        if (apart(told, exact, line) == 0.0) continue;
        ++between;
        EXPECT_GE(line, 15u);
    }
    EXPECT_GT(between, 15);
}

// Six points of the table and what the loaded seats add beside: the rail as it is solved line by line. The table is
// right to 3e-5 of the receptance here; below its second line, where the rail gives way as if it stood, to 1e-4.
TEST(RollingTable, RailsOfLoadedPadsAreThoseOfEveryLine) {
    CaseParameters c = rolling_case();
    c.track.pads.preload_strength = 0.8;
    const CoupledModel model = coupled_model(c, kTableSpeed);
    ASSERT_TRUE(model.rail->beside_equal_seats());
    constexpr std::size_t kLines = 200;
    const std::vector<RailGroup> told = rolling_rails(rolling_table(model, kTableSpeed, kEnd), model, 1.0, 1.0, kLines),
                                 exact = rail_groups(model, 1.0, 1.0, kLines, 1, 1);
    ASSERT_EQ(told.size(), exact.size());
    for (std::size_t group = 0; group < told.size(); ++group)
        for (int lane = 0; lane < lanes::width; ++lane) {
            const double size = std::abs(exact[group].rail[0][0][lane]);
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t j = 0; j < 4; ++j)
                    EXPECT_LT(std::abs(told[group].rail[i][j][lane] - exact[group].rail[i][j][lane]), 1e-4 * size)
                        << exact[group].omega[lane] / (2.0 * std::numbers::pi) << " Hz";
                EXPECT_LT(std::abs(told[group].trackbed[i][lane] - exact[group].trackbed[i][lane]),
                          1e-4 * std::abs(exact[group].trackbed[i][lane]));
            }
        }
}

// A rail that shears has an order more: nothing of a table without it tells how it changes.
TEST(RollingTable, OfAnotherKindTellsNothing) {
    const RollingTable before = table_of(rolling_case());
    CaseParameters shears = rolling_case();
    shears.track.rail.beam = track::Beam::timoshenko;
    const RollingTable exact = table_of(shears), told = table_of(shears, &before);
    ASSERT_EQ(exact.at.size(), told.at.size());
    for (std::size_t line = 0; line < exact.at.size(); ++line) EXPECT_EQ(apart(told, exact, line), 0.0);
}

}  // namespace
}  // namespace railpem::pem

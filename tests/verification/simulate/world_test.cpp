// The marched vehicle in an imperfect world: what every imperfection does to the march itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulate/march/simulate.hpp"
#include "simulate/march/world.hpp"
#include "simulate/world_grades.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::simulate {
namespace {

pem::CaseParameters short_case() {
    auto c = tests::paper_case(1);
    c.frequency.from_hz = 1.0;
    return c;
}

/// A line without irregularity, so that the march shows what else there is.
pem::CaseParameters smooth_case() {
    auto c = short_case();
    c.irregularity.level_db = -300.0;
    return c;
}

Options short_record(const std::string& grade) {
    Options options;
    options.seconds = 2.0;
    options.settling_s = 0.5;
    options.world = world_of_grade(grade);
    return options;
}

TEST(ImperfectWorld, SeedsGiveIdenticalBitsAndGradesAnotherRecord) {
    const Recording first = simulate(short_case(), short_record("worn"));
    const Recording again = simulate(short_case(), short_record("worn"));
    const Recording ideal = simulate(short_case(), short_record("ideal"));
    Options other = short_record("worn");
    other.seed = 2;
    const Recording third = simulate(short_case(), other);
    for (std::size_t c = 0; c < 9; ++c) {
        EXPECT_EQ(first.channels[c].acceleration_m_per_s2, again.channels[c].acceleration_m_per_s2);
        EXPECT_NE(first.channels[c].acceleration_m_per_s2, ideal.channels[c].acceleration_m_per_s2);
        EXPECT_NE(first.channels[c].acceleration_m_per_s2, third.channels[c].acceleration_m_per_s2);
    }
    EXPECT_NE(first.speed_m_per_s, ideal.speed_m_per_s);
    EXPECT_EQ(first.speed_m_per_s, first.making.draws.mean_speed_m_per_s);
    EXPECT_FALSE(first.making.draws.pad_stiffness.empty());
    EXPECT_TRUE(ideal.making.draws.pad_stiffness.empty());
}

TEST(ImperfectWorld, ASpeedTableThatHoldsTheSpeedIsTheConstantSpeed) {
    Options constant = short_record("ideal");
    constant.speed_m_per_s = 20.0;
    Options table = constant;
    table.speed_table = {{0.0, 1.0, 5.0}, {20.0, 20.0, 20.0}};
    table.speed_channel = true;
    table.profile_length_m = constant.profile_length_m = 150.0;
    const Recording a = simulate(short_case(), constant), b = simulate(short_case(), table);
    for (std::size_t c = 0; c < 9; ++c)
        for (std::size_t i = 0; i < a.samples(); i += 7)
            ASSERT_NEAR(a.channels[c].acceleration_m_per_s2[i], b.channels[c].acceleration_m_per_s2[i], 1e-5);
    EXPECT_NEAR(b.speed_m_per_s, 20.0, 1e-12);
    ASSERT_EQ(b.speed_channel_m_per_s.size(), b.samples());
    EXPECT_NEAR(b.speed_channel_m_per_s[1234], 20.0, 1e-12);
}

TEST(ImperfectWorld, ATrainThatStandsIsStill) {
    Options options = short_record("ideal");
    options.seconds = 4.0;
    options.speed_table = {{0.0, 1.0, 2.0}, {4.0, 0.0, 0.0}};
    const Recording recording = simulate(short_case(), options);
    const std::vector<double>& axle = recording.channels[0].acceleration_m_per_s2;
    double rolling = 0.0, standing = 0.0;
    for (std::size_t i = 0; i < 900; ++i) rolling = std::max(rolling, std::abs(axle[i]));
    for (std::size_t i = 3500; i < 3999; ++i) standing = std::max(standing, std::abs(axle[i]));
    EXPECT_GT(rolling, 1e-2);
    EXPECT_LT(standing, 1e-3 * rolling) << "what is left after 2.5 s is the car on its springs";
    EXPECT_NEAR(recording.speed_m_per_s, 0.5, 0.01) << "2 m in 4 s";
}

TEST(ImperfectWorld, EveryWheelMeetsADipWhereItLies) {
    Options options = short_record("ideal");
    options.speed_m_per_s = 30.0;
    options.world.impacts_per_km = 20.0;
    options.world.impact_depth_m = 3e-4;
    std::vector<Glimpse> seen;
    options.observer = [&](const Glimpse& glimpse) { seen.push_back(glimpse); };
    const Recording recording = simulate(smooth_case(), options);
    const std::vector<double> wheels = vehicle::wheel_positions(smooth_case().vehicle);
    std::size_t met = 0;
    for (const Dip& dip : recording.making.draws.dips) {
        const bool alone =
            std::none_of(recording.making.draws.dips.begin(), recording.making.draws.dips.end(), [&](const Dip& other) {
                return other.position_m != dip.position_m && std::abs(other.position_m - dip.position_m) < 1.0;
            });
        for (std::size_t j = 0; j < 4; ++j) {
            const double at_s = (dip.position_m - wheels[j]) / 30.0;
            if (!alone || at_s < 0.01 || at_s > 1.98) continue;
            const auto nearest = std::min_element(seen.begin(), seen.end(), [&](const Glimpse& a, const Glimpse& b) {
                return std::abs(a.time_s - at_s) < std::abs(b.time_s - at_s);
            });
            EXPECT_NEAR(nearest->irregularity_m[j], -dip.depth_m, 2e-3 * dip.depth_m);
            ++met;
        }
    }
    EXPECT_GE(met, 2u);
}

/// Rail under the wheels at rest, `distance_m` on, in the world that the options ask for.
std::array<double, 4> rail_at_rest(const pem::CaseParameters& c, const Options& options, double distance_m) {
    const World world = make_world(c, options, 1.0, options.largest_step_s, distance_m);
    std::array<double, 4> rail{};
    for (std::size_t j = 0; j < 4; ++j) {
        const Stencil at = stencil_at(world.track, world.wheel_offset_m + distance_m - world.behind_m[j]);
        rail[j] = at.shape[0] * world.track.w[at.node] + at.shape[1] * world.track.theta[at.node] +
                  at.shape[2] * world.track.w[at.node + 1] + at.shape[3] * world.track.theta[at.node + 1];
    }
    return rail;
}

/// Seats keep their factors as the window travels over them: a car that creeps over a scattered track presses the rail
/// down as one that was set down there. Both supports: pads on a sleeper, and pad and ground in series.
TEST(ImperfectWorld, ACreepingCarPressesTheRailDownAsOneSetDownThere) {
    for (const bool two_layers : {false, true}) {
        pem::CaseParameters c = smooth_case();
        if (two_layers)
            c.track.support = {.model = track::SupportModel::two_layer,
                               .mass_kg = 150,
                               .stiffness_n_per_m = 8e7,
                               .damping_n_s_per_m = 8e4};
        Options options = short_record("ideal");
        options.speed_m_per_s = 1.0;
        options.world.pad_scatter = 0.25;
        options.world.support_scatter = 0.35;
        options.world.support_length_m = 3.0;
        options.world.ground_share = 0.5;
        Glimpse last{};
        options.observer = [&](const Glimpse& glimpse) { last = glimpse; };
        simulate(c, options);
        const std::array<double, 4> rest = rail_at_rest(c, options, last.time_s);  // at 1 m/s
        Options ideal = options;
        ideal.world = {};
        const std::array<double, 4> uniform = rail_at_rest(c, ideal, last.time_s);
        double largest = 0.0;
        for (std::size_t j = 0; j < 4; ++j) {
            // Wheel loads of a car that creeps over uneven seats vary by the unevenness times the primary stiffness:
            // 1e-4 m of 2e6 N/m are 0.3 % of the load.
            EXPECT_NEAR(last.rail_displacement_m[j] / rest[j], 1.0, 0.01) << two_layers << " wheel " << j + 1;
            largest = std::max(largest, std::abs(rest[j] / uniform[j] - 1.0));
        }
        EXPECT_GT(largest, 0.04) << "the scatter is felt";
    }
}

}  // namespace
}  // namespace railpem::simulate

#include "diagnosis/judge/furthest_number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/unit/diagnosis/nature_of.hpp"

namespace railpem::diagnosis {
namespace {

/// Numbers that ended at so many times what was believed, each known to 5 %.
FittedSet ended_at(const std::map<std::string, double>& factors) {
    FittedSet set;
    for (const auto& [key, factor] : factors) {
        set.fit.unknowns.push_back(
            {.kind = UnknownKind::number, .name = key, .deviation = 0.05, .nature = nature_of(key)});
        set.fit.values.push_back(std::log(factor));
    }
    return set;
}

std::map<std::string, double> scaled_by(double scale) {
    return {{"vehicle.body_mass_kg", scale},
            {"vehicle.bogie_pitch_inertia_kg_m2", scale},
            {"vehicle.primary.damping_n_s_per_m", scale},
            {"track.rail.second_moment_of_area_m4", scale},
            {"track.rail.mass_kg_per_m", scale},
            {"track.pads.static_stiffness_n_per_m", scale},
            {"contact.constant_m_per_n23", std::pow(scale, -2.0 / 3.0)}};
}

constexpr double kTolerance = 0.05, kNothing = 1e-12;

// Nothing that a channel shows knows of it.
TEST(FurthestNumber, LeavesOutTheCommonScale) {
    EXPECT_LT(furthest_number(ended_at(scaled_by(1.4))), kNothing);
}

// What is off does not move the scale that it is held against.
TEST(FurthestNumber, IsThatAgainstAllOthers) {
    std::map<std::string, double> numbers = scaled_by(1.4);
    numbers["vehicle.primary.damping_n_s_per_m"] *= 0.5;
    EXPECT_NEAR(furthest_number(ended_at(numbers)), std::log(2.0) / kTolerance, kNothing);
}

// A loss factor goes with no scale, and neither does anything where a part is known exactly.
TEST(FurthestNumber, CountsInFullWhereNothingIsFree) {
    std::map<std::string, double> numbers = scaled_by(1.4);
    numbers["track.rail.loss_factor"] = 2.0;
    EXPECT_NEAR(furthest_number(ended_at(numbers)), std::log(2.0) / kTolerance, kNothing);
    EXPECT_NEAR(furthest_number(ended_at({{"vehicle.body_mass_kg", 1.4}, {"track.rail.mass_kg_per_m", 1.4}})),
                std::log(1.4) / kTolerance, kNothing);
    EXPECT_EQ(furthest_number({}), 0.0);
}

// One that is named as wrong may be; the others are held against each other.
TEST(FurthestNumber, IsNoneThatIsReleased) {
    std::map<std::string, double> numbers = scaled_by(1.4);
    numbers["vehicle.body_mass_kg"] *= 4.0;
    FittedSet set = ended_at(numbers);
    set.released = {"vehicle.body_mass_kg"};
    EXPECT_LT(furthest_number(set), kNothing);
}

// Hertz: F = (δ/G)^{3/2}, so that the stiffness under a load P is 3/2·P^{1/3}/G. Twice the load and twice the stiffness
// ask for 2^{−2/3} of G.
TEST(FurthestNumber, ContactsGoWithTheLoad) {
    const auto stiffness = [](double load, double constant) { return 1.5 * std::cbrt(load) / constant; };
    EXPECT_NEAR(stiffness(2.0, std::pow(2.0, power_of_scale(parameters::Nature::contact))) / stiffness(1.0, 1.0), 2.0,
                kNothing);
}

}  // namespace
}  // namespace railpem::diagnosis

// Values that are allowed and hardly believed.

#include <gtest/gtest.h>

#include "app/plausibility/implausible_case.hpp"
#include "app/plausibility/unit_slips.hpp"
#include "program_in_process.hpp"

namespace railpem::app {
namespace {

std::string doubts_of(const std::vector<std::string>& options) {
    const CaseFile file = read_case(shipped("ballasted/uic60.toml"), options);
    std::string text;
    for (const std::string& doubt : plausibility_warnings(file, case_figures(file))) text += doubt + "\n";
    return text;
}

TEST(Plausibility, OfShippedCasesNothingIsDoubted) {
    for (const char* name : {"ballasted/uic60.toml", "generic/axlebox.toml", "wei2016/case1.toml", "wei2016/case2.toml",
                             "wei2016/case3.toml", "wei2016/case3_consistent.toml"}) {
        const CaseFile file = read_case(shipped(name), {});
        EXPECT_TRUE(plausibility_warnings(file, case_figures(file)).empty()) << name;
    }
}

/// One slip each, with the unit that was probably meant.
TEST(Plausibility, NamesTheUnitThatWasProbablyMeant) {
    const std::pair<const char*, const char*> slips[] = {
        {"track.rail.youngs_modulus_pa=210", "GPa?"},
        {"track.rail.youngs_modulus_pa=2.1e5", "MPa or N/mm^2?"},
        {"track.rail.second_moment_of_area_m4=3055", "cm^4?"},
        {"track.rail.second_moment_of_area_m4=3.055e7", "mm^4?"},
        {"vehicle.body_mass_kg=38", "t?"},
        {"vehicle.body_pitch_inertia_kg_m2=2400", "t m^2?"},
        {"vehicle.primary.stiffness_n_per_m=1.2", "MN/m or kN/mm?"},
        {"vehicle.secondary.stiffness_n_per_m=400", "kN/m or N/mm?"},
        {"track.rail.mass_kg_per_m=0.0603", "t/m?"},
        {"track.rail.mass_kg_per_m=60300", "g/m?"},
        {"vehicle.wheel_radius_m=0.86", "a diameter?"},
        {"vehicle.bogie_distance_m=17500", "mm?"},
        {"track.support.mass_kg=0.15", "t?"},
        {"track.support.stiffness_n_per_m=60", "MN/m or kN/mm?"},
        {"contact.constant_m_per_n23=9.1e-7", ""},
        {"contact.constant_m_per_n23=1.3e9", ""},
        {"irregularity.band[1].longest_wavelength_m=150000", "mm?"},
    };
    for (const auto& [option, unit] : slips) {
        const std::string doubts = doubts_of({option});
        EXPECT_NE(doubts.find("hardly believed"), std::string::npos) << option;
        EXPECT_NE(doubts.find(unit), std::string::npos) << option << '\n' << doubts;
    }
}

/// Every number is believed by itself; what follows from them is not.
TEST(Plausibility, LooksAtWhatFollowsFromTheNumbers) {
    EXPECT_NE(doubts_of({"vehicle.secondary.stiffness_n_per_m=6e4"}).find("static deflection"), std::string::npos);
    EXPECT_NE(doubts_of({"track.pads.static_stiffness_n_per_m=4e6"}).find("pad compression"), std::string::npos);
    EXPECT_NE(doubts_of({"irregularity.level_db=35"}).find("a profile in mm"), std::string::npos);
}

TEST(Plausibility, IsAnErrorWhenStrict) {
    const Scratch folder;
    const std::vector<std::string> slip{"--set", "vehicle.body_mass_kg=38", "--set", "frequency.step_hz=5"};
    std::vector<std::string> solve{"solve", shipped("ballasted/uic60.toml"), "--out", folder.path("out")};
    solve.insert(solve.end(), slip.begin(), slip.end());
    const ProgramResult warned = run(solve);
    EXPECT_EQ(warned.status, 0);
    EXPECT_NE(warned.message.find("warning: --set vehicle.body_mass_kg=38: vehicle.body_mass_kg = 38 kg"),
              std::string::npos)
        << warned.message;
    EXPECT_NE(folder.read("out/uic60.summary.json").find("t?"), std::string::npos);
    solve.push_back("--strict");
    solve[3] = folder.path("strict");
    EXPECT_EQ(run(solve).status, 2);
    EXPECT_FALSE(folder.has("strict"));
}

TEST(UnitSlips, ChooseTheUnitNearestToTheMiddle) {
    EXPECT_EQ(likely_unit(210.0, "Pa", 1.5e11, 2.5e11), "GPa?");
    EXPECT_EQ(likely_unit(120.0, "m/s", 0.5, 100.0), "km/h?");
    EXPECT_EQ(likely_unit(5.0, "Pa", 1.5e11, 2.5e11), "");
    EXPECT_EQ(likely_unit(5.0, "no unit", 1.0, 2.0), "");
}

}  // namespace
}  // namespace railpem::app

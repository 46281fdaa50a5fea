// Every way to write a case file wrong, with the whole message that the user sees.

#include <gtest/gtest.h>

#include "program_run.hpp"

namespace railpem::tests {
namespace {

constexpr const char* kVehicleKeys =
    "body_mass_kg, body_pitch_inertia_kg_m2, bogie_mass_kg, bogie_pitch_inertia_kg_m2, wheelset_mass_kg, "
    "bogie_distance_m, wheelbase_m, "
    "wheel_radius_m, payload_kg, primary, secondary, body_bending, wheelset_bending, bogie_mounted_mass";

TEST(RefusedCases, TheMinimalCaseItselfIsSolved) {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    const Outcome outcome = folder.run({"solve", "case.toml", "--out", "new/results"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.message, "");
    EXPECT_EQ(folder.content(), (std::vector<std::string>{"case.toml", "new", "new/results", "new/results/case.psd.csv",
                                                          "new/results/case.summary.json"}));
}

TEST(RefusedCases, MissingKey) {
    expect_refused(minimal_case("body_mass_kg = 38500.0\n", ""),
                   "case.toml:1:1: [vehicle] has no 'body_mass_kg' (mass of the whole car body)\n"
                   "  1 | [vehicle]\n"
                   "    | ^^^^^^^^^\n"
                   "allowed: a number greater than 0, in kg");
}

TEST(RefusedCases, MissingTable) {
    expect_refused(minimal_case("[frequency]\nfrom_hz = 0.5\nto_hz = 100.0\nstep_hz = 0.5\n", ""),
                   "case.toml: [frequency] has no 'from_hz' (first frequency line)\n"
                   "allowed: a number greater than 0, in Hz");
}

TEST(RefusedCases, EmptyFile) {
    expect_refused("",
                   "case.toml: [vehicle] has no 'body_mass_kg' (mass of the whole car body)\n"
                   "allowed: a number greater than 0, in kg");
}

TEST(RefusedCases, MisspelledKey) {
    expect_refused(minimal_case("body_mass_kg", "body_mas_kg"),
                   std::string("case.toml:2:1: unknown key 'body_mas_kg' in [vehicle]\n"
                               "  2 | body_mas_kg = 38500.0\n"
                               "    | ^^^^^^^^^^^\n"
                               "allowed: ") +
                       kVehicleKeys + "\ndid you mean 'body_mass_kg'?");
}

TEST(RefusedCases, MisspelledTable) {
    expect_refused(minimal_case("[track.pads]", "[track.pad]"),
                   "case.toml:26:8: unknown table [track.pad]\n"
                   "  26 | [track.pad]\n"
                   "     |        ^^^\n"
                   "allowed: spacing_m, wheel_offset_m, rail, pads, support, static, rail_damper, failed_fasteners\n"
                   "did you mean 'pads'?");
}

TEST(RefusedCases, WrongUnitSuffix) {
    expect_refused(minimal_case("body_pitch_inertia_kg_m2 = 2.5e6", "body_pitch_inertia_t_m2 = 2500"),
                   std::string("case.toml:3:1: unknown key 'body_pitch_inertia_t_m2' in [vehicle]\n"
                               "  3 | body_pitch_inertia_t_m2 = 2500\n"
                               "    | ^^^^^^^^^^^^^^^^^^^^^^^\n"
                               "allowed: ") +
                       kVehicleKeys + "\ndid you mean 'body_pitch_inertia_kg_m2', in kg m^2?");
}

TEST(RefusedCases, WrongUnitSuffixOfTheSpeed) {
    expect_refused(minimal_case("speeds_m_per_s = 22.2", "speeds_km_per_h = 80"),
                   "case.toml:36:1: unknown key 'speeds_km_per_h' in [running]\n"
                   "  36 | speeds_km_per_h = 80\n"
                   "     | ^^^^^^^^^^^^^^^\n"
                   "allowed: speeds_m_per_s, speed_fluctuation\n"
                   "did you mean 'speeds_m_per_s', in m/s?");
}

TEST(RefusedCases, KeyOfAnotherTable) {
    expect_refused(minimal_case("step_hz = 0.5", "step_hz = 0.5\nreference_frequency_hz = 4.0"),
                   "case.toml:42:1: unknown key 'reference_frequency_hz' in [frequency]\n"
                   "  42 | reference_frequency_hz = 4.0\n"
                   "     | ^^^^^^^^^^^^^^^^^^^^^^\n"
                   "allowed: from_hz, to_hz, step_hz\n"
                   "did you mean 'track.pads.reference_frequency_hz'?");
}

TEST(RefusedCases, NegativeMass) {
    expect_refused(minimal_case("38500.0", "-38500.0"),
                   "case.toml:2:16: 'body_mass_kg' cannot be -38500\n"
                   "  2 | body_mass_kg = -38500.0\n"
                   "    |                ^^^^^^^^\n"
                   "allowed: a number greater than 0, in kg");
}

TEST(RefusedCases, MassThatIsNoNumber) {
    expect_refused(minimal_case("38500.0", "nan"),
                   "case.toml:2:16: 'body_mass_kg' cannot be nan\n"
                   "  2 | body_mass_kg = nan\n"
                   "    |                ^^^\n"
                   "allowed: a number greater than 0, in kg");
}

TEST(RefusedCases, InfiniteMass) {
    expect_refused(minimal_case("38500.0", "inf"),
                   "case.toml:2:16: 'body_mass_kg' cannot be inf\n"
                   "  2 | body_mass_kg = inf\n"
                   "    |                ^^^\n"
                   "allowed: a number greater than 0, in kg");
}

TEST(RefusedCases, TextInPlaceOfANumber) {
    expect_refused(minimal_case("38500.0", "\"38.5 t\""),
                   "case.toml:2:16: 'body_mass_kg' cannot be a text\n"
                   "  2 | body_mass_kg = \"38.5 t\"\n"
                   "    |                ^^^^^^^^\n"
                   "allowed: a number greater than 0, in kg");
}

TEST(RefusedCases, WrongElementOfAList) {
    expect_refused(minimal_case("speeds_m_per_s = 22.2", "speeds_m_per_s = [22.2, -1.0]"),
                   "case.toml:36:25: 'speeds_m_per_s' cannot be -1\n"
                   "  36 | speeds_m_per_s = [22.2, -1.0]\n"
                   "     |                         ^^^^\n"
                   "allowed: numbers greater than 0 and at most 200, in m/s (one, or a list)");
}

TEST(RefusedCases, ZeroModes) {
    expect_refused(minimal_case("modes = 200", "modes = 0"),
                   "case.toml:45:9: 'modes' cannot be 0\n"
                   "  45 | modes = 0\n"
                   "     |         ^\n"
                   "allowed: an integer between 1 and 5000");
}

TEST(RefusedCases, FractionalModes) {
    expect_refused(minimal_case("modes = 200", "modes = 200.5"),
                   "case.toml:45:9: 'modes' cannot be a number\n"
                   "  45 | modes = 200.5\n"
                   "     |         ^^^^^\n"
                   "allowed: an integer between 1 and 5000");
}

TEST(RefusedCases, UnknownChoice) {
    expect_refused(minimal_case("\"exact\"", "\"exakt\""),
                   "case.toml:44:8: 'rail' cannot be \"exakt\"\n"
                   "  44 | rail = \"exakt\"\n"
                   "     |        ^^^^^^^\n"
                   "allowed: \"exact\", \"modal\"\n"
                   "did you mean \"exact\"?");
}

TEST(RefusedCases, WheelOutsideTheTrack) {
    expect_refused(minimal_case("rail = \"exact\"\nmodes = 200\npads = 61", "rail = \"modal\"\nmodes = 200\npads = 31"),
                   "case.toml:46:8: solver.pads: wheel 1 stands at 10.2 m, off the track, which ends at 9 m\n"
                   "  46 | pads = 31\n"
                   "     |        ^^\n"
                   "allowed: more pads, or a shorter vehicle");
}

TEST(RefusedCases, EmptyFrequencyGrid) {
    expect_refused(minimal_case("to_hz = 100.0", "to_hz = 0.1"),
                   "case.toml:40:9: frequency.to_hz: the frequency grid is empty\n"
                   "  40 | to_hz = 0.1\n"
                   "     |         ^^^\n"
                   "allowed: greater than frequency.from_hz");
}

TEST(RefusedCases, FrequencyZero) {
    expect_refused(minimal_case("from_hz = 0.5", "from_hz = 0.0"),
                   "case.toml:39:11: 'from_hz' cannot be 0\n"
                   "  39 | from_hz = 0.0\n"
                   "     |           ^^^\n"
                   "allowed: a number greater than 0, in Hz");
}

TEST(RefusedCases, EndlessFrequencyGrid) {
    expect_refused(minimal_case("step_hz = 0.5", "step_hz = 1e-9"),
                   "case.toml:41:11: frequency.step_hz: 9.95e+10 frequency lines are more than two million\n"
                   "  41 | step_hz = 1e-9\n"
                   "     |           ^^^^\n"
                   "allowed: at least 4.98e-05 Hz, or no step_hz");
}

TEST(RefusedCases, SingleFrequencyLine) {
    expect_refused(minimal_case("to_hz = 100.0", "to_hz = 0.5"),
                   "case.toml:40:9: frequency.to_hz: a single frequency line, 0.5 Hz, holds no power: it has no rms\n"
                   "  40 | to_hz = 0.5\n"
                   "     |         ^^^\n"
                   "allowed: greater than frequency.from_hz");
}

TEST(RefusedCases, StepWiderThanTheBand) {
    expect_refused(minimal_case("step_hz = 0.5", "step_hz = 100"),
                   "case.toml:41:11: frequency.step_hz: the step of 100 Hz is wider than the band from 0.5 to 100 Hz\n"
                   "  41 | step_hz = 100\n"
                   "     |           ^^^\n"
                   "allowed: at most 99.5 Hz, or no step_hz: then the program chooses the lines");
}

TEST(RefusedCases, AVehicleOfAnotherLayout) {
    const std::string note =
        "a vehicle here is a body on two bogies of two wheelsets, all alike; one of another layout (two axles, one "
        "bogie, three axles, unequal axle loads, articulated) cannot be described";
    const ProgramFolder folder;
    folder.write("two.toml", minimal_case("wheelbase_m = 2.4\n", ""));
    folder.write("axle.toml", minimal_case("[vehicle.primary]", "[[vehicle.axle]]\nload_n = 1\n[vehicle.primary]"));
    for (const char* name : {"two.toml", "axle.toml"}) {
        const Outcome outcome = folder.run({"validate", name});
        EXPECT_EQ(outcome.status, 2);
        EXPECT_NE(outcome.message.find(note), std::string::npos) << outcome.message;
    }
}

TEST(RefusedCases, ValidateListsAllOfThem) {
    const ProgramFolder folder;
    std::string text = minimal_case("spacing_m = 0.6", "spacing_m = -1\nspacin_m = 0.6");
    text.replace(text.find("from_hz = 0.5"), 13, "from_hz = true");
    folder.write("case.toml", text);
    const Outcome outcome = folder.run({"validate", "case.toml"});
    EXPECT_EQ(outcome.status, 2);
    for (const char* words :
         {"'spacing_m' cannot be -1", "unknown key 'spacin_m'", "'from_hz' cannot be true or false", "\n3 errors"})
        EXPECT_NE(outcome.message.find(words), std::string::npos) << words << "\n" << outcome.message;
}

TEST(RefusedCases, BandThatTheSpeedCannotExcite) {
    const std::string second =
        "\n[[irregularity.band]]\nfamily = \"fra\"\nshortest_wavelength_m = 0.01\nlongest_wavelength_m = 0.02\n";
    expect_refused(minimal_case("\n[running]", second + "\n[running]"),
                   "case.toml:37:25: irregularity.band[2].shortest_wavelength_m: at 22.2 m/s wavelengths of 0.01 to "
                   "0.02 m excite 1110 to 2220 Hz, none "
                   "of it between 0.5 and 100 Hz\n"
                   "  37 | shortest_wavelength_m = 0.01\n"
                   "     |                         ^^^^\n"
                   "allowed: a band of wavelengths that the speed turns into frequencies of the grid");
}

TEST(RefusedCases, RuleBetweenKeysThatAreNotInTheFile) {
    expect_refused(
        minimal_case("damping_n_s_per_m = 7.5e4", "preload_strength = 1.0"),
        "case.toml:28:20: track.pads.preload_strength: a stiffness from the static equilibrium needs a static curve\n"
        "  28 | preload_strength = 1.0\n"
        "     |                    ^^^\n"
        "allowed: 0, or give force_polynomial_n or curve_force_n");
}

TEST(RefusedCases, ToleranceOfWhatIsNotThere) {
    expect_refused(minimal_case("[solver]", "[tolerance]\n\"vehicle.body_mass\" = 0.1\n[solver]"),
                   "case.toml:44:1: [tolerance] names 'vehicle.body_mass', which is not a number of this file\n"
                   "  44 | \"vehicle.body_mass\" = 0.1\n"
                   "     | ^^^^^^^^^^^^^^^^^^^\n"
                   "allowed: the dotted key of a number, such as vehicle.body_mass_kg\n"
                   "did you mean 'vehicle.body_mass_kg'?");
}

TEST(RefusedCases, NotToml) {
    expect_refused(minimal_case("38500.0", "38500,0"),
                   "case.toml:2:21: not valid TOML: Error while parsing key-value pair: expected a comment or "
                   "whitespace, saw ','\n"
                   "  2 | body_mass_kg = 38500,0\n"
                   "    |                     ^\n"
                   "allowed: lines such as  key = 1.5,  key = \"text\",  key = [1.0, 2.0],  [table],  # comment");
}

TEST(RefusedCases, KeyGivenTwice) {
    expect_refused(minimal_case("wheelbase_m = 2.4", "wheelbase_m = 2.4\nwheelbase_m = 2.5"),
                   "case.toml:9:15: not valid TOML: Error while parsing key-value pair: cannot redefine existing "
                   "floating-point 'wheelbase_m'\n"
                   "  9 | wheelbase_m = 2.5\n"
                   "    |               ^\n"
                   "allowed: lines such as  key = 1.5,  key = \"text\",  key = [1.0, 2.0],  [table],  # comment");
}

TEST(RefusedCases, BinaryGarbage) {
    expect_refused(std::string("\x7f"
                               "ELF\x02\x01\x01\x00\xff\xfe garbage",
                               18),
                   "case.toml:1:8: not valid TOML: Encountered invalid utf-8 sequence\n"
                   "  1 | ?ELF?????? garbage\n"
                   "    |        ^\n"
                   "allowed: lines such as  key = 1.5,  key = \"text\",  key = [1.0, 2.0],  [table],  # comment");
}

TEST(RefusedCases, OptionOutOfRange) {
    expect_refused(minimal_case(),
                   "--set vehicle.body_mass_kg=-5: 'body_mass_kg' cannot be -5\n"
                   "allowed: a number greater than 0, in kg",
                   {"vehicle.body_mass_kg=-5"});
}

TEST(RefusedCases, OptionWithAnUnknownKey) {
    expect_refused(minimal_case(),
                   "--set solver.rial=modal: unknown key 'rial' in [solver]\n"
                   "allowed: rail, modes, pads, moving\n"
                   "did you mean 'rail'?",
                   {"solver.rial=modal"});
}

TEST(RefusedCases, OptionWithoutAValue) {
    expect_refused(minimal_case(),
                   "--set solver.rail: no key and value\n"
                   "allowed: --set key=value, such as --set vehicle.payload_kg=5000",
                   {"solver.rail"});
}

TEST(RefusedCases, OptionForAnElementThatIsNotThere) {
    expect_refused(minimal_case(),
                   "--set irregularity.band[3].exponent=3: there is no band[3]\n"
                   "allowed: band[1] to band[2]",
                   {"irregularity.band[3].exponent=3"});
}

}  // namespace
}  // namespace railpem::tests

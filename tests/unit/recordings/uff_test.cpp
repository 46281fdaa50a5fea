// Universal files as other programs write them: axes, widths, functions, units.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recordings/files/compound_unit.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/uff.hpp"
#include "recordings/loading/load_recording.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;

/// A dataset 58 in text: function type, record 7, units of records 8 to 10, lines of data.
struct Written {
    int function = 1;
    std::string record_7;
    int abscissa_kind = 17, ordinate_kind = 12, denominator_kind = 0;
    std::string abscissa_unit = "s", ordinate_unit = "m/s^2", denominator_unit = "NONE";
    std::string data;
    std::string name = "NONE";
};

std::string axis(int kind, const std::string& unit) {
    char line[128];
    std::snprintf(line, sizeof line, "%10d    0    0    0 %-20s %-20s\n", kind, "NONE", unit.c_str());
    return line;
}

std::string dataset(const Written& written) {
    char record_6[128];
    std::snprintf(record_6, sizeof record_6,
                  "%5d         0    0         0 NONE               1   3 NONE               0   0\n", written.function);
    return "    -1\n    58\n" + written.name + "\nNONE\n11-Feb-22 09:30:00\nNONE\nNONE\n" + record_6 +
           written.record_7 + "\n" + axis(written.abscissa_kind, written.abscissa_unit) +
           axis(written.ordinate_kind, written.ordinate_unit) +
           axis(written.denominator_kind, written.denominator_unit) + axis(0, "NONE") + written.data + "    -1\n";
}

std::string refusal(const std::string& file, const std::string& record) {
    try {
        uff_time_table(file, {record});
    } catch (const ReadError& error) {
        return std::to_string(error.line()) + ": " + error.problem();
    }
    return "accepted";
}

TEST(UffAxis, AListedAbscissaInEvenStepsIsEven) {
    // Two columns of E20.12 a line, where the standard has E13.5 and E20.12, and lines without padding.
    const ScratchFolder folder;
    std::string data;
    for (int i = 0; i < 5; ++i) {
        char line[64];
        std::snprintf(line, sizeof line, "%20.12E %20.12E\n", 0.002 * i, 1.5 * i);
        data += line;
    }
    const std::string file = folder.write(
        "a.uff",
        dataset({.record_7 = "         4         5         0  0.00000E+00  0.00000E+00  0.00000E+00", .data = data}));
    const DataTable table = uff_time_table(file, {"1"});
    EXPECT_DOUBLE_EQ(table.sampling_rate_hz, 500.0);
    EXPECT_EQ(table.columns[0], (std::vector<double>{0, 1.5, 3, 4.5, 6}));
}

TEST(UffAxis, AnUnevenAbscissaIsRefusedWithItsSteps) {
    const ScratchFolder folder;
    const std::string file = folder.write(
        "a.uff", dataset({.record_7 = "         2         3         0  0.00000E+00  0.00000E+00  0.00000E+00",
                          .data = "  0.00000E+00  1.00000E+00  1.00000E-03  2.00000E+00  4.00000E-03  3.00000E+00\n"}));
    EXPECT_EQ(refusal(file, "1"), "2: the record '1' is not on an even axis: its steps run from 0.001 to 0.003 s");
}

TEST(UffAxis, MillisecondsAreMilliseconds) {
    const ScratchFolder folder;
    const std::string file = folder.write(
        "a.uff", dataset({.record_7 = "         2         3         1  0.00000E+00  2.00000E+00  0.00000E+00",
                          .abscissa_unit = "ms",
                          .data = "  1.00000E+00  2.00000E+00  3.00000E+00\n"}));
    EXPECT_DOUBLE_EQ(uff_time_table(file, {"1"}).sampling_rate_hz, 500.0);
}

TEST(UffNumbers, OtherWidthsAndBareExponentsAreRead) {
    const ScratchFolder folder;
    const std::string file =
        folder.write("a.uff", dataset({.record_7 = "4 6 1 0.0 0.001 0.0",  // not in its columns
                                       .data = "-1.0E+00-2.0E+00\n   3.5D0 4\n 1.25-101  6.000000000000000E+00\n"}));
    const DataTable table = uff_time_table(file, {"1"});
    EXPECT_DOUBLE_EQ(table.sampling_rate_hz, 1000.0);
    ASSERT_EQ(table.rows(), 6U);
    EXPECT_EQ(table.columns[0][1], -2.0);
    EXPECT_EQ(table.columns[0][2], 3.5);
    EXPECT_NEAR(table.columns[0][4] / 1.25e-101, 1.0, 1e-12);
    EXPECT_EQ(table.columns[0][5], 6.0);
}

TEST(UffNumbers, AnEarlyEndIsSaidWithBothCounts) {
    const ScratchFolder folder;
    const std::string file = folder.write(
        "a.uff", dataset({.record_7 = "         2         9         1  0.00000E+00  1.00000E-03  0.00000E+00",
                          .data = "  1.00000E+00  2.00000E+00  3.00000E+00\n"}));
    EXPECT_EQ(refusal(file, "1"), "15: the dataset ends here: 3 of its 9 numbers are there");
}

RecordingDescription one_channel(const std::string& unit) {
    RecordingDescription d;
    d.data = "a.uff";
    d.channels = {{.name = "a", .column = "1", .unit = unit, .location = Location::wheel, .index = 1}};
    return d;
}

TEST(UffUnit, OfTheFileIsUsedAndHeldAgainstTheDescription) {
    const ScratchFolder folder;
    folder.write("a.uff", dataset({.record_7 = "         2         3         1  0.00000E+00  2.00000E-03  0.00000E+00",
                                   .ordinate_unit = "g",
                                   .data = "  1.00000E+00  2.00000E+00  3.00000E+00\n"}));
    const Recording silent = load(one_channel(""), folder.path());
    EXPECT_DOUBLE_EQ(silent.series.channels[0].samples[1], 2.0 * 9.80665);
    EXPECT_TRUE(silent.contradictions.empty());
    const Recording other = load(one_channel("m/s^2"), folder.path());
    EXPECT_DOUBLE_EQ(other.series.channels[0].samples[1], 2.0);
    ASSERT_EQ(other.contradictions.size(), 1U);
    EXPECT_NE(other.contradictions[0].says.find("'g' (record 9)"), std::string::npos);
}

TEST(UffSpectra, DensitiesComeInTheirUnit) {
    const ScratchFolder folder;
    const Written density = {
        .function = 9,
        .record_7 = "         5         3         1  0.00000E+00  5.00000E-01  0.00000E+00",
        .abscissa_kind = 18,
        .ordinate_kind = 0,
        .abscissa_unit = "Hz",
        .ordinate_unit = "g\xB2/Hz",  // Latin-1
        .data = "  1.00000E-03  0.00000E+00  2.00000E-03  0.00000E+00  4.00000E-03  0.00000E+00\n"};
    folder.write("a.uff", dataset(density));
    RecordingDescription d = one_channel("");
    d.kind = RecordingKind::psd;
    d.averages = 100;
    const Recording recording = load(d, folder.path());
    ASSERT_EQ(recording.spectra.size(), 1U);
    EXPECT_EQ(recording.spectra[0].frequency_hz, (std::vector<double>{0.0, 0.5, 1.0}));
    EXPECT_DOUBLE_EQ(recording.spectra[0].psd[1], 2e-3 * 9.80665 * 9.80665);
    EXPECT_DOUBLE_EQ(recording.spectra[0].standard_error[1], 0.1 * recording.spectra[0].psd[1]);
    EXPECT_EQ(refusal(folder.file("a.uff"), "1"),
              "2: the record '1' is no time response: complex, power spectral density (function type 9)");
    // An auto-spectrum is a density only when its unit says so.
    Written power = density;
    power.function = 2;
    folder.write("a.uff", dataset(power));
    EXPECT_EQ(load(d, folder.path()).spectra[0].psd, recording.spectra[0].psd);
    power.ordinate_unit = "g";
    folder.write("a.uff", dataset(power));
    EXPECT_THROW(load(d, folder.path()), ReadError);
}

Written response(int kind, const std::string& unit, const std::string& force = "NONE") {
    return {.function = 4,
            .record_7 = "         5         1         1  1.00000E+01  1.00000E+00  0.00000E+00",
            .abscissa_kind = 18,
            .ordinate_kind = kind,
            .denominator_kind = 13,
            .abscissa_unit = "Hz",
            .ordinate_unit = unit,
            .denominator_unit = force,
            .data = " -1.00000E+00  0.00000E+00\n"};
}

TEST(UffResponse, IsReceptanceWhateverWasMeasured) {
    const ScratchFolder folder;
    RecordingDescription d;
    d.kind = RecordingKind::receptance;
    d.data = "a.uff";
    const double omega = 2.0 * std::numbers::pi * 10.0, g = 9.80665;
    const auto value = [&](const Written& written) {
        folder.write("a.uff", dataset(written));
        return load(d, folder.path()).receptance.value_m_per_n.at(0);
    };
    EXPECT_NEAR(value(response(12, "g")).real() * omega * omega / g, 1.0, 1e-12);
    EXPECT_NEAR(value(response(12, "g/N")).real() * omega * omega / g, 1.0, 1e-12);
    EXPECT_NEAR(value(response(0, "(m/s^2)/N")).real() * omega * omega, 1.0, 1e-12);
    EXPECT_NEAR(value(response(12, "m/N/s^2")).real() * omega * omega, 1.0, 1e-12);
    EXPECT_NEAR(value(response(12, "m/s^2", "kN")).real() * omega * omega * 1e3, 1.0, 1e-12);
    EXPECT_NEAR(value(response(12, "NONE")).real() * omega * omega, 1.0, 1e-12);
    EXPECT_NEAR(value(response(11, "mm/s/N")).imag() * omega * 1e3, 1.0, 1e-12);
    EXPECT_NEAR(value(response(8, "mm/kN")).real() * 1e6, -1.0, 1e-12);
}

TEST(UffResponse, OfTwoMindsOrToNoForceIsRefused) {
    const ScratchFolder folder;
    RecordingDescription d;
    d.kind = RecordingKind::receptance;
    d.data = "a.uff";
    const auto refused = [&](const Written& written) {
        folder.write("a.uff", dataset(written));
        try {
            load(d, folder.path());
        } catch (const ReadError& error) {
            return error.problem();
        }
        return std::string("accepted");
    };
    EXPECT_EQ(refused(response(8, "g/N")),
              "record 9 says displacement (data type 8) and 'g/N', a unit of acceleration");
    Written transmissibility = response(12, "g");
    transmissibility.denominator_kind = 12;
    EXPECT_NE(refused(transmissibility).find("not to a force"), std::string::npos);
    EXPECT_NE(refused(response(0, "NONE")).find("neither by data type nor by unit"), std::string::npos);
}

TEST(UffResponse, OfSeveralTheNamedOneIsUsed) {
    const ScratchFolder folder;
    Written first = response(8, "m/N"), second = response(8, "m/N");
    second.name = "mid bay";
    second.data = "  3.00000E+00  0.00000E+00\n";
    folder.write("a.uff", dataset(first) + dataset(second));
    RecordingDescription d;
    d.kind = RecordingKind::receptance;
    d.data = "a.uff";
    const Recording unnamed = load(d, folder.path());
    EXPECT_EQ(unnamed.receptance.value_m_per_n.at(0).real(), -1.0);
    EXPECT_NE(unnamed.notes.front().find("2 frequency responses"), std::string::npos);
    d.channels = {{.name = "rail", .column = "mid bay"}};
    EXPECT_EQ(load(d, folder.path()).receptance.value_m_per_n.at(0).real(), 3.0);
}

TEST(CompoundUnits, AreTakenApart) {
    for (const char* unit : {"g^2/Hz", "g\xC2\xB2/Hz", "g2/Hz", "(g)^2/Hz", "(g^2)/Hz", "[g^2/Hz]"})
        EXPECT_EQ(unit_of_density(unit), "g") << unit;
    for (const char* unit :
         {"(m/s^2)^2/Hz", "(m/s\xC2\xB2)\xC2\xB2/Hz", "m^2/s^4/Hz", "m2/s4/Hz", "(m/s2)2/Hz", "m^2/s^3"})
        EXPECT_EQ(unit_of_density(unit), "m/s^2") << unit;
    EXPECT_EQ(unit_of_density("(mm/s)^2/Hz"), "mm/s");
    EXPECT_EQ(unit_of_density("mm^2/s^2/Hz"), "mm/s");
    EXPECT_EQ(unit_of_density("um^2/Hz"), "um");
    for (const char* unit : {"g", "g/sqrt(Hz)", "V^2/Hz", "dB", "", "/Hz"})
        EXPECT_EQ(unit_of_density(unit), std::nullopt) << unit;
    EXPECT_EQ(unit_per_force("m/s^2/N").unit, "m/s^2");
    EXPECT_EQ(unit_per_force("m/(N*s^2)").unit, "m/s^2");
    EXPECT_EQ(unit_per_force("um/kN").newtons, 1e3);
    EXPECT_FALSE(unit_per_force("g").has_force);
}

}  // namespace
}  // namespace railpem::recordings

// Measured irregularities named by a case: read, converted, refused with their line.

#include "app/schema/irregularity_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "app/schema/case_file.hpp"
#include "program_in_process.hpp"
#include "spectra/irregularity_spectrum.hpp"
#include "spectra/profile_spectrum.hpp"

namespace railpem::app {
namespace {

/// The shipped case 1 with its irregularity replaced.
std::string case_with(const std::string& band) {
    const Scratch nothing;
    std::string text = nothing.read(shipped("wei2016/case1.toml"));
    const std::size_t begin = text.find("[[irregularity.band]]"), end = text.find("[running]");
    return text.substr(0, begin) + "[[irregularity.band]]\n" + band +
           "shortest_wavelength_m = 0.5\nlongest_wavelength_m = 50.0\n\n" + text.substr(end);
}

std::string message_of(const Scratch& scratch) {
    try {
        read_case(scratch.path("case.toml"), {});
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(IrregularityFiles, SpectrumRelativeToTheCase) {
    const Scratch scratch;
    scratch.write("case.toml", case_with("family = \"table\"\nfile = \"track.csv\"\n"));
    scratch.write("track.csv", "# measured\ncycles_per_m,psd_m3\n0.02,4e-5\n0.2,4e-8\n2,4e-11\n");
    const CaseFile file = read_case(scratch.path("case.toml"), {});
    const spectra::IrregularityBand& band = file.parameters.irregularity.bands.at(0);
    EXPECT_EQ(band.table_psd_m3, (std::vector<double>{4e-5, 4e-8, 4e-11}));
    EXPECT_DOUBLE_EQ(spectra::band_psd_m3(band, 0.2), 4e-8);
    EXPECT_NEAR(spectra::band_psd_m3(band, 1.0) / 3.2e-10, 1.0, 1e-12);  // a straight line of slope −3 in log–log
    // The case as written again needs the file no more.
    const CaseFile again = parse_case("again.toml", write_case(file.parameters), {});
    EXPECT_EQ(again.parameters.irregularity.bands.at(0).table_psd_m3, band.table_psd_m3);
}

/// Columns in any order, with others beside them and semicolons between: the reader of recordings.
TEST(IrregularityFiles, OtherDialectsAndColumns) {
    const Scratch scratch;
    scratch.write("case.toml", case_with("family = \"table\"\nfile = \"track.csv\"\n"));
    scratch.write("track.csv", "psd_m3;note;cycles_per_m\n4e-5;1;0,02\n4e-8;2;0,2\n");
    EXPECT_EQ(read_case(scratch.path("case.toml"), {}).parameters.irregularity.bands.at(0).table_cycles_per_m,
              (std::vector<double>{0.02, 0.2}));
}

/// A profile with one wave of 5 m and 1 mm amplitude: its spectrum holds amplitude²/2 around 0.2 cycles/m.
TEST(IrregularityFiles, ProfileBecomesItsSpectrum) {
    const Scratch scratch;
    scratch.write("case.toml", case_with("family = \"profile\"\nfile = \"profile.csv\"\nsegment_length_m = 100.0\n"));
    std::ostringstream text;
    text.precision(12);
    text << "position_m,height_m\n";
    for (int i = 0; i < 4000; ++i)
        text << 0.25 * i << ',' << 1e-3 * std::sin(2.0 * std::numbers::pi * 0.25 * i / 5.0) << '\n';
    scratch.write("profile.csv", text.str());
    const CaseFile file = read_case(scratch.path("case.toml"), {});
    const spectra::IrregularityBand& band = file.parameters.irregularity.bands.at(0);
    EXPECT_EQ(band.family, spectra::Family::table);
    EXPECT_EQ(band.shortest_wavelength_m, 0.5);  // what the case says, not what the file holds
    double power = 0.0;
    for (std::size_t i = 0; i < band.table_psd_m3.size(); ++i)
        power += band.table_psd_m3[i] * 0.01;  // lines every 1/100 m
    EXPECT_NEAR(power / 0.5e-6, 1.0, 1e-3);  // whole waves in a segment; the straight line takes less than 1e-3 of them
}

TEST(IrregularityFiles, ErrorsOfTheFileHaveItsLine) {
    const Scratch scratch;
    scratch.write("case.toml", case_with("family = \"table\"\nfile = \"track.csv\"\n"));
    const std::string csv = scratch.path("track.csv");
    const auto refused = [&](const std::string& text) {
        scratch.write("track.csv", text);
        return message_of(scratch);
    };
    EXPECT_EQ(refused("cycles_per_m,psd_m3\n\n0.1,1e-6\n0.1,1e-7\n"),
              csv + ":4: cycles_per_m does not increase\nallowed: strictly increasing values");
    EXPECT_EQ(refused("cycles_per_m,psd_m3\n0.1,1e-6\n0.2,0\n"),
              csv + ":3: psd_m3 cannot be 0\nallowed: a number greater than 0 (the spectrum is interpolated log-log)");
    EXPECT_EQ(refused("cycles_per_m,psd_m3\n0,1e-6\n0.2,1e-7\n"),
              csv + ":2: cycles_per_m cannot be 0\nallowed: a number greater than 0");
    EXPECT_EQ(refused("cycles_per_m,psd_m3\n0.1,1e-6\n0.2,\n"),
              csv + ":3: a value is missing\nallowed: a number in cycles_per_m and psd_m3");
    EXPECT_EQ(refused("cycles_per_m,psd_m3\n0.1,1e-6\n0.2,much\n")
                  .rfind(csv + ":3: 'much' in column 'psd_m3' is not a number", 0),
              0u);
    EXPECT_EQ(refused("cycles_per_m,psd\n0.1,1e-6\n0.2,1e-7\n").rfind(csv + ":1: ", 0), 0u);
}

TEST(IrregularityFiles, ErrorsOfTheWholeStandInTheCase) {
    const Scratch scratch;
    const auto refused = [&](const std::string& band) {
        scratch.write("case.toml", case_with(band));
        return message_of(scratch);
    };
    const std::string missing = refused("family = \"profile\"\nfile = \"nowhere.csv\"\n");
    EXPECT_NE(missing.find("file = \"nowhere.csv\""), std::string::npos) << missing;
    EXPECT_NE(missing.find("irregularity.band[1].file: " + scratch.path("nowhere.csv")), std::string::npos) << missing;
    scratch.write("uneven.csv",
                  "position_m,height_m\n0,0\n1,1\n5,2\n6,3\n7,1\n8,1\n9,1\n10,1\n11,1\n12,1\n13,1\n14,1\n15,1\n16,"
                  "1\n17,1\n18,1\n19,1\n");
    const std::string uneven = refused("family = \"profile\"\nfile = \"uneven.csv\"\n");
    EXPECT_NE(uneven.find("the positions do not increase in even steps"), std::string::npos) << uneven;
    EXPECT_NE(refused("family = \"profile\"\n").find("irregularity.band[1].file: a profile that has not been read"),
              std::string::npos);
    EXPECT_NE(refused("family = \"fra\"\nfile = \"uneven.csv\"\n").find("this family reads no file"),
              std::string::npos);
    EXPECT_NE(refused("family = \"table\"\nfile = \"uneven.csv\"\ntable_psd_m3 = [1.0, 2.0]\n")
                  .find("both here and as a file"),
              std::string::npos);
}

}  // namespace
}  // namespace railpem::app

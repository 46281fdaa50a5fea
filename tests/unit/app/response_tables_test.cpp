#include "app/tables/response_tables.hpp"
#include "pem/response_names.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/progress_bar.hpp"
#include "app/tables/response_summary.hpp"
#include "spectra/comfort.hpp"

namespace railpem::app {
namespace {

/// A flat spectrum of 1 in every response, lines 1 … 9 Hz.
ResponseSpectra flat(double speed) {
    ResponseSpectra spectra{.speed_m_per_s = speed, .frequency_hz = {1, 2, 3, 4, 5, 6, 7, 8, 9}};
    spectra.psd.assign(pem::response_names().size(), std::vector<double>(9, 1.0));
    return spectra;
}

TEST(NumberTable, WritesNineDigitsAndNoRoundingNoise) {
    const NumberTable table{
        .names = {"a", "b"},
        .columns = {{0.3 + 7 * 0.1, -1.23456789012e-12}, {1e300, std::numeric_limits<double>::infinity()}}};
    EXPECT_EQ(csv_text(table), "a,b\n1,1e+300\n-1.23456789e-12,\n");
    EXPECT_EQ(csv_text({.names = {"a"}, .columns = {{}}}), "a\n");
}

TEST(PsdTable, HasTheColumnsOfTheContract) {
    const NumberTable table = psd_table({flat(20.0)});
    std::vector<std::string> expected{"frequency_hz"};
    for (const char* where : {"body", "body_front", "body_rear", "bogie_1", "bogie_2", "wheel_1", "wheel_2", "wheel_3",
                              "wheel_4", "rail_1", "rail_2", "rail_3", "rail_4"})
        expected.push_back(std::string(where) + "_acceleration_psd_m2_per_s4_per_hz");
    for (const char* where : {"contact_1", "contact_2", "contact_3", "contact_4", "trackbed"})
        expected.push_back(std::string(where) + "_force_psd_n2_per_hz");
    EXPECT_EQ(table.names, expected);
    EXPECT_EQ(table.columns.size(), expected.size());
}

TEST(PsdTable, StacksSeveralSpeeds) {
    const NumberTable table = psd_table({flat(20.0), flat(30.0)});
    EXPECT_EQ(table.names[0], "speed_m_per_s");
    EXPECT_EQ(table.names[1], "frequency_hz");
    ASSERT_EQ(table.columns[0].size(), 18u);
    EXPECT_EQ(table.columns[0][8], 20.0);
    EXPECT_EQ(table.columns[0][9], 30.0);
    EXPECT_EQ(table.columns[1][9], 1.0);
}

TEST(BandsTable, LevelsOfAFlatSpectrum) {
    const NumberTable table = bands_table({flat(20.0)});
    EXPECT_EQ(table.names.front(), "centre_hz");
    EXPECT_EQ(table.names.size(), 14u) << "accelerations only";
    // Whole bands between 1 and 9 Hz: centres 1.25 to 8 (upper edge 10^0.95 = 8.91 Hz).
    EXPECT_EQ(table.columns.front(), (std::vector<double>{1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8}));
    // Mean square of a density of 1: the width of the band 10^(0.3) Hz·(10^0.05 − 10^−0.05); re 1e-6: + 120 dB.
    const double width = std::pow(10.0, 0.3) * (std::pow(10.0, 0.05) - std::pow(10.0, -0.05));
    EXPECT_NEAR(table.columns[1][2], 120.0 + 10.0 * std::log10(width), 1e-9);  // rounding only
}

TEST(Summary, RmsPeakAndItsFrequency) {
    ResponseSpectra spectra = flat(20.0);
    spectra.psd[pem::response_index("wheel_1")][3] = 5.0;
    spectra.warnings = {"careful"};
    const nlohmann::json summary = nlohmann::json::parse(summary_text({.name = "case"}, {}, {spectra}));
    const nlohmann::json& speed = summary["speeds"][0];
    const nlohmann::json& wheel = speed["acceleration"]["wheel_1"];
    // Trapezoids: eight of width 1 under a density of 1, plus a triangle of height 4 and base 2.
    EXPECT_NEAR(wheel["rms_m_per_s2"].get<double>(), std::sqrt(8.0 + 4.0), 1e-12);
    EXPECT_EQ(wheel["peak_psd_m2_per_s4_per_hz"], 5.0);
    EXPECT_EQ(wheel["peak_frequency_hz"], 4.0);
    EXPECT_NEAR(speed["force"]["trackbed"]["rms_n"].get<double>(), std::sqrt(8.0), 1e-12);
    EXPECT_EQ(speed["warnings"][0], "careful");
    EXPECT_TRUE(speed["comfort"]["body"]["weighted_rms_iso2631_m_per_s2"].is_null())
        << "1 to 9 Hz do not cover 0.5 to 80 Hz";
}

/// A flat acceleration spectrum over 0.4 to 100 Hz: every measure of comfort is that of spectra/comfort.hpp.
TEST(Summary, ComfortWhereTheLinesCoverIt) {
    ResponseSpectra spectra{.speed_m_per_s = 20.0};
    for (int i = 0; i < 997; ++i) spectra.frequency_hz.push_back(0.4 + 0.1 * i);
    spectra.psd.assign(pem::response_names().size(), std::vector<double>(997, 1e-3));
    const nlohmann::json speed = nlohmann::json::parse(summary_text({.name = "case"}, {}, {spectra}))["speeds"][0];
    const std::vector<double>&f = spectra.frequency_hz, &psd = spectra.psd[0];
    for (const char* where : {"body", "body_front", "body_rear"}) {
        const nlohmann::json& comfort = speed["comfort"][where];
        EXPECT_EQ(comfort["weighted_rms_iso2631_m_per_s2"].get<double>(), *spectra::weighted_rms_iso2631(f, psd));
        const spectra::VerticalComfort vertical = *spectra::vertical_comfort_en12299(f, psd);
        EXPECT_EQ(comfort["mean_comfort_en12299"].get<double>(), vertical.mean_comfort);
        EXPECT_EQ(comfort["percentile_95_en12299_m_per_s2"].get<double>(), vertical.percentile_95_m_per_s2);
        EXPECT_EQ(comfort["sperling_index"].get<double>(), *spectra::sperling_index_vertical(f, psd));
    }
}

/// A power law of exponent 2, S(n) = c/n²: between n1 and n2 the mean square is c(1/n1 − 1/n2).
TEST(Summary, RmsOfTheIrregularityThatWasMet) {
    pem::CaseParameters parameters;
    parameters.irregularity.bands = {{.family = spectra::Family::power_law,
                                      .shortest_wavelength_m = 0.01,
                                      .longest_wavelength_m = 1e4,
                                      .coefficient_m3 = 1e-7,
                                      .exponent = 2.0}};
    parameters.vehicle.payload_kg = 1234.0;
    ResponseSpectra spectra{.speed_m_per_s = 20.0};
    for (int i = 0; i <= 9000; ++i) spectra.frequency_hz.push_back(1.0 + 0.01 * i);
    spectra.psd.assign(pem::response_names().size(), std::vector<double>(9001, 1.0));
    const nlohmann::json summary =
        nlohmann::json::parse(summary_text({.name = "case", .parameters = parameters}, {}, {spectra}));
    EXPECT_EQ(summary["payload_kg"], 1234.0);
    const nlohmann::json& met = summary["speeds"][0]["irregularity"];
    const double n1 = 1.0 / 20.0, n2 = 91.0 / 20.0;
    // trapezoids: (step/f)²/6 at 1 Hz
    EXPECT_NEAR(met["rms_m"].get<double>() / std::sqrt(1e-7 * (1.0 / n1 - 1.0 / n2)), 1.0, 1e-4);
    EXPECT_DOUBLE_EQ(met["longest_wavelength_m"].get<double>(), 20.0);
    EXPECT_DOUBLE_EQ(met["shortest_wavelength_m"].get<double>(), 20.0 / 91.0);
}

TEST(ProgressLine, ShowsShareAndRemainingTime) {
    EXPECT_EQ(progress_line("case1", 0.5, 65.0), "case1  [###############               ]  50 %  remaining 1:05");
    EXPECT_EQ(progress_line("case1", 1.0, 10.0), "case1  [##############################] 100 %  remaining 0:00");
}

}  // namespace
}  // namespace railpem::app

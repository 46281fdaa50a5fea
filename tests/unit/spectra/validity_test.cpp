#include "spectra/validity.hpp"

#include <gtest/gtest.h>

namespace railpem::spectra {
namespace {

TEST(Validity, SilentWithinTheMeasuredWavelengths) {
    IrregularityParameters irregularity;
    irregularity.bands = {{.family = Family::german_low, .shortest_wavelength_m = 3.0, .longest_wavelength_m = 150.0},
                          {.family = Family::iso3095, .shortest_wavelength_m = 0.01, .longest_wavelength_m = 0.4},
                          {.family = Family::power_law,
                           .shortest_wavelength_m = 0.01,
                           .longest_wavelength_m = 1000.0,
                           .coefficient_m3 = 1e-8,
                           .exponent = 3.0}};
    EXPECT_TRUE(validity_warnings(irregularity).empty());
}

TEST(Validity, SaysWhichBandGoesBeyond) {
    IrregularityParameters irregularity;
    irregularity.bands = {{.family = Family::german_high, .shortest_wavelength_m = 3.0, .longest_wavelength_m = 150.0},
                          {.family = Family::german_low, .shortest_wavelength_m = 0.4, .longest_wavelength_m = 150.0}};
    const std::vector<std::string> warnings = validity_warnings(irregularity);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0],
              "irregularity.band[2] goes from 0.4 to 150 m, its family was measured for wavelengths of 3 to 150 m; "
              "beyond them it is extrapolated");
}

TEST(Validity, BeyondATableThereIsNothing) {
    IrregularityParameters irregularity;
    irregularity.bands = {{.family = Family::table,
                           .shortest_wavelength_m = 0.5,
                           .longest_wavelength_m = 60.0,
                           .table_cycles_per_m = {0.02, 2.0},
                           .table_psd_m3 = {1e-5, 1e-9}}};
    EXPECT_EQ(validity_warnings(irregularity).at(0),
              "irregularity.band[1] goes from 0.5 to 60 m, its family was measured for wavelengths of 0.5 to 50 m; "
              "beyond them there is no irregularity");
}

}  // namespace
}  // namespace railpem::spectra

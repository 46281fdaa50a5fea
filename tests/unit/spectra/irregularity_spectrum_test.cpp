#include "spectra/irregularity_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "spectra/spectrum_families.hpp"

namespace railpem::spectra {
namespace {

IrregularityParameters wei2016() {
    IrregularityParameters irregularity;
    irregularity.bands = {
        {.family = Family::fra, .shortest_wavelength_m = 1.0, .longest_wavelength_m = 100.0, .fra_class = 6},
        {.family = Family::power_law,
         .shortest_wavelength_m = 0.1,
         .longest_wavelength_m = 1.0,
         .coefficient_m3 = 0.036e-6,
         .exponent = 3.15}};
    return irregularity;
}

constexpr double eighty_km_per_h = 80.0 / 3.6;

TEST(IrregularitySpectrum, JumpsBySixteenWhereTheShortWavesBegin) {
    // FRA class 6 and Wei et al. 2016, eq. (9) at 1 m: 0.036e-6/2.2833e-9 = 15.77.
    const auto irregularity = wei2016();
    const double below = irregularity_psd_m2_per_hz(irregularity, 22.2222, eighty_km_per_h);
    const double above = irregularity_psd_m2_per_hz(irregularity, 22.2223, eighty_km_per_h);
    // The two frequencies are 4.5e-6 apart and the slopes are about −4.
    EXPECT_NEAR(above / below, 0.036e-6 / 2.2833197178845765e-09, 15.77 * 4.0 * 4.5e-6);
    EXPECT_NEAR(above / below, 16.0, 0.5);
}

TEST(IrregularitySpectrum, NothingBeyondTheWavelengths) {
    const auto irregularity = wei2016();
    EXPECT_EQ(irregularity_psd_m2_per_hz(irregularity, 0.2222, eighty_km_per_h), 0.0);
    EXPECT_GT(irregularity_psd_m2_per_hz(irregularity, 0.2223, eighty_km_per_h), 0.0);
    EXPECT_GT(irregularity_psd_m2_per_hz(irregularity, 222.2, eighty_km_per_h), 0.0);
    EXPECT_EQ(irregularity_psd_m2_per_hz(irregularity, 222.3, eighty_km_per_h), 0.0);
}

TEST(IrregularitySpectrum, BandsThatMeetDoNotCountTwice) {
    EXPECT_DOUBLE_EQ(irregularity_psd_m3(wei2016(), 1.0), fra_psd_m3(6, 1.0));
}

TEST(IrregularitySpectrum, OverlappingBandsAdd) {
    auto irregularity = wei2016();
    irregularity.bands[1].longest_wavelength_m = 2.0;
    EXPECT_DOUBLE_EQ(irregularity_psd_m3(irregularity, 0.7),
                     fra_psd_m3(6, 0.7) + power_law_psd_m3(0.036e-6, 3.15, 0.7));
}

TEST(IrregularitySpectrum, TimeKeepsThePower) {
    // S(f) df = S(n) dn.
    const auto irregularity = wei2016();
    for (const double v : {10.0, eighty_km_per_h, 100.0})
        EXPECT_DOUBLE_EQ(irregularity_psd_m2_per_hz(irregularity, 0.3 * v, v) * v,
                         irregularity_psd_m3(irregularity, 0.3 * v / v));
}

TEST(IrregularitySpectrum, LevelHoldsAtThreeMetresAndSlopePerOctave) {
    const auto plain = wei2016();
    auto corrected = plain;
    corrected.level_db = 6.0;
    corrected.slope_db_per_octave = 2.0;
    const auto change_db = [&](double wavelength_m) {
        return 10.0 * std::log10(irregularity_psd_m3(corrected, 1.0 / wavelength_m) /
                                 irregularity_psd_m3(plain, 1.0 / wavelength_m));
    };
    // 1e-12 dB: rounding of logarithms of the order of ten.
    EXPECT_NEAR(change_db(3.0), 6.0, 1e-12);
    EXPECT_NEAR(change_db(6.0), 8.0, 1e-12);
    EXPECT_NEAR(change_db(0.75), 2.0, 1e-12);
}

TEST(IrregularitySpectrum, CorrugationHasItsRmsAtAnyBandwidth) {
    for (const double bandwidth : {0.005, 0.1, 0.5}) {
        IrregularityParameters irregularity;
        irregularity.corrugation = {{.wavelength_m = 0.3, .relative_bandwidth = bandwidth, .rms_m = 20e-6}};
        // Midpoint rule over all n > 0 that matter (ten deviations): for a Gaussian it converges faster than any power;
        // where the Gaussian is cut at n = 0 the error is of the order (step/deviation)²/24·5 %: 3e-9 at 1/1000.
        const double step = bandwidth / 0.3 / 1000.0;
        double sum = 0.0;
        for (double n = std::max(0.0, (1.0 - 10.0 * bandwidth) / 0.3) + 0.5 * step; n < (1.0 + 10.0 * bandwidth) / 0.3;
             n += step)
            sum += irregularity_psd_m3(irregularity, n) * step;
        EXPECT_NEAR(std::sqrt(sum) / 20e-6, 1.0, 1e-8) << "bandwidth " << bandwidth;
    }
}

TEST(IrregularitySpectrum, CorrectionLeavesCorrugationAlone) {
    auto irregularity = wei2016();
    irregularity.corrugation = {{.wavelength_m = 0.05, .relative_bandwidth = 0.05, .rms_m = 5e-6}};
    const double before = irregularity_psd_m3(irregularity, 20.0);  // no band reaches 0.05 m
    irregularity.level_db = 10.0;
    EXPECT_GT(before, 0.0);
    EXPECT_EQ(irregularity_psd_m3(irregularity, 20.0), before);
}

}  // namespace
}  // namespace railpem::spectra

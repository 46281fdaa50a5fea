#include "spectra/log_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "spectra/irregularity_spectrum.hpp"

namespace railpem::spectra {
namespace {

IrregularityParameters irregularity() {
    IrregularityParameters result;
    result.bands = {
        {.family = Family::fra, .shortest_wavelength_m = 0.1, .longest_wavelength_m = 100.0, .fra_class = 6}};
    result.corrugation = {{.wavelength_m = 0.3, .relative_bandwidth = 0.1, .rms_m = 20e-6}};
    return result;
}

TEST(LogSpline, PowerLawBetweenNodesConstantBeyond) {
    const LogSpline spline{.wavelength_m = {0.5, 8.0}, .log_factor = {std::log(3.0), std::log(48.0)}};  // 6·λ
    EXPECT_NEAR(spline.at(2.0), 12.0, 1e-14);
    EXPECT_NEAR(spline.at(1.3), 7.8, 1e-14);
    EXPECT_NEAR(spline.at(0.1), 3.0, 1e-15);
    EXPECT_NEAR(spline.at(100.0), 48.0, 2e-14);
    EXPECT_EQ(LogSpline{}.at(2.0), 1.0);
    const LogFrequencySpline by_frequency{.frequency_hz = spline.wavelength_m, .log_factor = spline.log_factor};
    for (const double x : {0.1, 1.3, 100.0}) EXPECT_EQ(by_frequency.at(x), spline.at(x));
    EXPECT_EQ(LogFrequencySpline{}.at(2.0), 1.0);
}

/// A spline through a line in log–log is what level_db and slope_db_per_octave do.
TEST(LogSpline, WaveCorrectionEqualsLevelAndSlopeAndSparesCorrugation) {
    IrregularityParameters reference = irregularity(), corrected = irregularity();
    reference.level_db = 2.0;
    reference.slope_db_per_octave = -1.5;
    const auto log_factor = [&](double wavelength) {
        return 0.1 * std::log(10.0) * (2.0 - 1.5 * std::log2(wavelength / 3.0));
    };
    corrected.wave_correction = {.wavelength_m = {0.05, 1.0, 200.0},
                                 .log_factor = {log_factor(0.05), log_factor(1.0), log_factor(200.0)}};
    for (const double n : {0.011, 0.2, 1.0, 3.3, 9.0})
        EXPECT_NEAR(irregularity_psd_m3(corrected, n) / irregularity_psd_m3(reference, n), 1.0, 1e-13) << n;
}

TEST(LogSpline, FrequencyCorrectionActsInTimeOnly) {
    const IrregularityParameters plain = irregularity();
    IrregularityParameters corrected = plain;
    corrected.frequency_correction = {.frequency_hz = {10.0}, .log_factor = {std::log(1.2)}};
    for (const double f : {1.0, 30.0, 66.7}) {
        EXPECT_EQ(irregularity_psd_m3(corrected, f / 20.0), irregularity_psd_m3(plain, f / 20.0));
        EXPECT_NEAR(irregularity_psd_m2_per_hz(corrected, f, 20.0) / irregularity_psd_m2_per_hz(plain, f, 20.0), 1.2,
                    1e-14)
            << f;
    }
}

}  // namespace
}  // namespace railpem::spectra

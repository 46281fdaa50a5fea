// A measured kilometre of track through the chain profile → spectrum → case. Skipped where the recording is absent: set
// RAILPEM_RECORDINGS to the folder of public recordings.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "spectra/integrate_psd.hpp"
#include "spectra/irregularity_spectrum.hpp"
#include "spectra/profile_spectrum.hpp"

namespace railpem::spectra {
namespace {

TEST(MeasuredProfile, OneKilometreOfTrack) {
    const char* folder = std::getenv("RAILPEM_RECORDINGS");
    if (folder == nullptr) GTEST_SKIP() << "RAILPEM_RECORDINGS is not set";
    std::ifstream file(std::string(folder) + "/track-alignment-1km/track_alignment.txt");
    if (!file) GTEST_SKIP() << "no track-alignment-1km in RAILPEM_RECORDINGS";
    std::vector<double> position, height;
    for (double tenths_of_millimetres = 0.0; file >> tenths_of_millimetres;) {
        position.push_back(0.25 * static_cast<double>(position.size()));
        height.push_back(1e-4 * tenths_of_millimetres);
    }
    ASSERT_EQ(height.size(), 4000u);
    const auto spectrum = spectrum_of_profile(position, height, 250.0);
    // The same estimate by scipy.signal.welch (1000 samples, Hann, half overlap, linear detrend) and integrated with
    // NumPy between 3 and 25 m: 1.2000207982113402 mm; 1e-12 for rounding. This is the sharp band. The standard
    // deviation of level D1 that is quoted for these data, 1.03 mm, has the fourth-order band-pass run forwards and
    // backwards, which leaves a quarter of the power at the ends of the band (SciPy: 1.033 mm; run once: 1.284 mm).
    const double d1_m = std::sqrt(*mean_square_between(spectrum.cycles_per_m, spectrum.psd_m3, 1.0 / 25.0, 1.0 / 3.0));
    EXPECT_NEAR(d1_m / 1.2000207982113402e-3, 1.0, 1e-12);
    // What a case makes of it has the same power.
    IrregularityParameters irregularity;
    irregularity.bands = {measured_band(spectrum)};
    check(irregularity);
    std::vector<double> psd;
    for (const double n : spectrum.cycles_per_m) psd.push_back(irregularity_psd_m3(irregularity, n));
    const double again_m = std::sqrt(*mean_square_between(spectrum.cycles_per_m, psd, 1.0 / 25.0, 1.0 / 3.0));
    EXPECT_NEAR(again_m / d1_m, 1.0, 1e-12);
}

}  // namespace
}  // namespace railpem::spectra

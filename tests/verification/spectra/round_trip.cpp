// Every family of irregularity: a profile is generated from the spectrum, its spectrum estimated, and the power of the
// estimate compared with the integral of the family over the same wavelengths, octave by octave.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <kissfft/kissfft.hh>
#include <numbers>
#include <numeric>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "spectra/integrate_psd.hpp"
#include "spectra/irregularity_spectrum.hpp"
#include "spectra/profile_spectrum.hpp"

namespace railpem::spectra {
namespace {

struct Case {
    std::string name;
    IrregularityParameters irregularity;
    double shortest_wavelength_m, longest_wavelength_m;
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

Case family(std::string name, Family kind, double shortest_m, double longest_m) {
    IrregularityBand band{.family = kind, .shortest_wavelength_m = shortest_m, .longest_wavelength_m = longest_m};
    if (kind == Family::power_law) {
        band.coefficient_m3 = 0.036e-6;
        band.exponent = 3.15;
    }
    if (kind == Family::table) {
        band.table_cycles_per_m = {0.01, 0.1, 0.4, 1.0};
        band.table_psd_m3 = {1e-4, 2e-6, 5e-9, 1e-9};
    }
    IrregularityParameters irregularity;
    irregularity.bands = {band};
    return {std::move(name), irregularity, shortest_m, longest_m};
}

struct Profile {
    std::vector<double> position_m, height_m;
    double variance_m2 = 0.0;
};

// z(x) = Σ √(2 S(n_k) Δn) cos(2πn_k x + φ_k), n_k = kΔn, random phases: the record is one period of it, so that its
// variance is Σ S(n_k)Δn exactly.
Profile random_phase_profile(const IrregularityParameters& irregularity, std::size_t samples, double step_m,
                             unsigned seed) {
    const double resolution = 1.0 / (static_cast<double>(samples) * step_m);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
    std::vector<std::complex<double>> lines(samples), heights(samples);
    Profile profile;
    for (std::size_t k = 1; k < samples / 2; ++k) {
        const double power = irregularity_psd_m3(irregularity, static_cast<double>(k) * resolution) * resolution;
        lines[k] = std::polar(std::sqrt(2.0 * power), phase(random));
        profile.variance_m2 += power;
    }
    kissfft<double>(samples, true).transform(lines.data(), heights.data());
    for (std::size_t i = 0; i < samples; ++i) {
        profile.position_m.push_back(static_cast<double>(i) * step_m);
        profile.height_m.push_back(heights[i].real());
    }
    return profile;
}

double integral(const IrregularityParameters& irregularity, double low, double high) {
    constexpr int intervals = 2000;
    const double step = (high - low) / intervals;
    double sum = 0.0;
    for (int i = 0; i < intervals; ++i) sum += irregularity_psd_m3(irregularity, low + (i + 0.5) * step) * step;
    return sum;
}

class RoundTrip : public testing::TestWithParam<Case> {};

TEST_P(RoundTrip, VarianceOfTheProfile) {
    const Case& c = GetParam();
    const auto profile = random_phase_profile(c.irregularity, 1 << 16, c.shortest_wavelength_m / 4.0, 1);
    double sum = 0.0;
    for (const double z : profile.height_m) sum += z * z / static_cast<double>(profile.height_m.size());
    EXPECT_NEAR(sum / profile.variance_m2, 1.0, 1e-10);  // Parseval; rounding of 65536 terms
    // Σ S Δn against ∫S dn: a rectangle rule whose spacing 1/(16384·shortest) is at least 80 times finer than the
    // lowest n. S falls like n^−4 at worst: at most ½·Δn·S(n_low) plus a line at the band's end, 4·Δn/n_low = 5 % at 80
    // lines.
    const double low = 1.0 / c.longest_wavelength_m, spacing = 1.0 / (16384.0 * c.shortest_wavelength_m);
    const double whole = integral(c.irregularity, low, 16.0 * low) +
                         (16.0 * low * c.shortest_wavelength_m < 1.0
                              ? integral(c.irregularity, 16.0 * low, 1.0 / c.shortest_wavelength_m)
                              : 0.0);
    EXPECT_NEAR(profile.variance_m2 / whole, 1.0, 4.0 * spacing / low);
}

TEST_P(RoundTrip, OctavesOfTheEstimate) {
    const Case& c = GetParam();
    constexpr unsigned profiles = 20;
    const double segment_m = 10.0 * c.longest_wavelength_m;
    std::vector<ProfileSpectrum> spectra;
    for (unsigned seed = 1; seed <= profiles; ++seed) {
        const auto profile = random_phase_profile(c.irregularity, 1 << 16, c.shortest_wavelength_m / 4.0, seed);
        spectra.push_back(spectrum_of_profile(profile.position_m, profile.height_m, segment_m));
    }
    // Octaves inside the band, two bins away from its ends, over which the window spreads the jump to zero.
    const double resolution = 1.0 / spectra.front().segment_length_m;
    for (double low = 1.0 / c.longest_wavelength_m + 2.0 * resolution;
         2.0 * low < 1.0 / c.shortest_wavelength_m - 2.0 * resolution; low *= 2.0) {
        const double expected = integral(c.irregularity, low, 2.0 * low);
        double sum = 0.0, squares = 0.0;
        for (const ProfileSpectrum& spectrum : spectra) {
            const double ratio =
                *mean_square_between(spectrum.cycles_per_m, spectrum.psd_m3, low, 2.0 * low) / expected;
            sum += ratio;
            squares += ratio * ratio;
        }
        const double mean = sum / profiles;
        const double standard_error = std::sqrt((squares / profiles - mean * mean) / (profiles - 1));
        // Four standard errors of the mean as found from the profiles, and the curvature S''/S = 20/n² of n^−4 (the
        // steepest of all) seen through the Hann window (second moment 1/3 bin², half of it) and between the bins
        // (straight lines: 1/12). The straight line removed takes nothing above two cycles per segment but leakage.
        const double bias = 20.0 * std::pow(resolution / low, 2) * (1.0 / 6.0 + 1.0 / 12.0);
        EXPECT_NEAR(mean, 1.0, 4.0 * standard_error + bias) << "from " << low << " 1/m";
        EXPECT_LT(standard_error, 0.01) << "too few profiles to say anything from " << low << " 1/m";
    }
}

std::vector<Case> all_families() {
    std::vector<Case> cases = {family("fra", Family::fra, 1.0, 100.0),
                               family("power_law", Family::power_law, 0.1, 1.0),
                               family("german_low", Family::german_low, 3.0, 100.0),
                               family("german_high", Family::german_high, 3.0, 100.0),
                               family("chinese_ballastless", Family::chinese_ballastless, 2.0, 150.0),
                               family("iso3095", Family::iso3095, 0.00315, 0.4),
                               family("table", Family::table, 1.0, 100.0)};
    Case corrected = family("fra_with_level_slope_and_corrugation", Family::fra, 1.0, 100.0);
    corrected.irregularity.level_db = 3.0;
    corrected.irregularity.slope_db_per_octave = -1.0;
    corrected.irregularity.corrugation = {{.wavelength_m = 2.0, .relative_bandwidth = 0.1, .rms_m = 5e-4}};
    cases.push_back(corrected);
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Families, RoundTrip, testing::ValuesIn(all_families()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace railpem::spectra

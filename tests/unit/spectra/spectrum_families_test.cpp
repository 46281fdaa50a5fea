#include "spectra/spectrum_families.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "spectra/integrate_psd.hpp"

namespace railpem::spectra {
namespace {

// Pinned values: the published formulas evaluated independently in double precision with NumPy, in rad/m and the
// published units, converted at the end. 1e-12: both are a dozen rounded operations.
constexpr double rounding = 1e-12;

void expect_relative(double value, double expected, double tolerance) {
    EXPECT_NEAR(value / expected, 1.0, tolerance) << value << " for " << expected;
}

// ∫S dn by Simpson's rule in ln n.
double variance(const std::function<double(double)>& psd, double low, double high) {
    constexpr int intervals = 4000;
    const double step = std::log(high / low) / intervals;
    double sum = 0.0;
    for (int i = 0; i <= intervals; ++i) {
        const double n = low * std::exp(i * step);
        const double weight = i == 0 || i == intervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        sum += weight * psd(n) * n;
    }
    return sum * step / 3.0;
}

TEST(FraSpectrum, EveryClassAtTenMetres) {
    constexpr std::array expected = {0.00030474561176525405, 0.000256266215691918,  0.00017156571320657235,
                                     0.0001353194357685641,  5.273329946710227e-05, 8.532977813531107e-06};
    for (int track_class = 1; track_class <= 6; ++track_class)
        expect_relative(fra_psd_m3(track_class, 0.1), expected[static_cast<std::size_t>(track_class - 1)], rounding);
}

TEST(FraSpectrum, ClassSixOverTwoDecades) {
    expect_relative(fra_psd_m3(6, 0.01), 0.0013410501874436755, rounding);
    expect_relative(fra_psd_m3(6, 1.0), 2.2833197178845765e-09, rounding);
}

TEST(FraSpectrum, VarianceIsTheIntegralInRadians) {
    // Closed form of ∫S(Ω)dΩ by partial fractions, 1 to 100 m: the change of variable loses no power.
    constexpr double k_a = 0.25 * 0.0339e-4, cut_off = 0.8245, pi = 3.14159265358979323846;
    const double low = 2.0 * pi / 100.0, high = 2.0 * pi;
    const double closed_form =
        k_a * (1.0 / low - 1.0 / high - (std::atan(high / cut_off) - std::atan(low / cut_off)) / cut_off);
    // Simpson with 4000 intervals over 4.6 of ln n: error of the order step⁴ = 1.8e-12.
    expect_relative(variance([](double n) { return fra_psd_m3(6, n); }, 0.01, 1.0), closed_form, 1e-10);
}

TEST(PowerLaw, ShortWavesOfWei) {
    EXPECT_DOUBLE_EQ(power_law_psd_m3(0.036e-6, 3.15, 1.0), 0.036e-6);
    expect_relative(power_law_psd_m3(0.036e-6, 3.15, 10.0), 0.036e-6 * std::pow(10.0, -3.15), rounding);
}

TEST(GermanSpectra, PinnedValues) {
    expect_relative(german_low_psd_m3(0.01), 0.0005760842446305889, rounding);
    expect_relative(german_low_psd_m3(0.1), 4.0555854002476624e-06, rounding);
    expect_relative(german_low_psd_m3(1.0), 1.0865417857979344e-09, rounding);
    expect_relative(german_high_psd_m3(0.1), 1.086317517923481e-05, rounding);
}

TEST(GermanSpectra, StandardDeviationsFromThreeToTwentyFiveMetres) {
    // SciPy's adaptive quadrature of the one-sided reading: 0.984 mm (low) and 1.611 mm (high), the sizes of D1
    // longitudinal level on which that reading rests (README.md). Simpson's error as above.
    expect_relative(variance(german_low_psd_m3, 1.0 / 25.0, 1.0 / 3.0), 9.687938981909748e-07, 1e-10);
    expect_relative(variance(german_high_psd_m3, 1.0 / 25.0, 1.0 / 3.0), 2.594983655868682e-06, 1e-10);
}

TEST(ChineseBallastless, OneValueInEverySection) {
    expect_relative(chinese_ballastless_psd_m3(0.01), 6.327110179143243e-05, rounding);
    expect_relative(chinese_ballastless_psd_m3(0.03), 3.0622681115658764e-06, rounding);
    expect_relative(chinese_ballastless_psd_m3(0.1), 4.5773498102774814e-07, rounding);
    expect_relative(chinese_ballastless_psd_m3(0.3), 2.519030438121672e-08, rounding);
}

TEST(ChineseBallastless, SectionsMeet) {
    // The published constants have five digits; the sections meet within 0.4 % (0.40, 0.06 and 0.04 %).
    for (const double end : {0.0187, 0.0474, 0.1533})
        expect_relative(chinese_ballastless_psd_m3(end * (1 + 1e-9)), chinese_ballastless_psd_m3(end * (1 - 1e-9)),
                        0.0041);
}

TEST(Iso3095, BandsGiveTheLevelsBack) {
    // ISO 3095:2013, limit of the rail roughness in dB re 1e-6 m, from 400 mm to 3.15 mm.
    constexpr std::array levels = {17.1, 15.0, 13.0, 11.0, 9.0,  7.0,  4.9,  2.9,  0.9,  -1.1,  -3.2,
                                   -5.0, -5.6, -6.2, -6.8, -7.4, -8.0, -8.6, -9.2, -9.8, -10.4, -11.0};
    for (std::size_t band = 0; band < levels.size(); ++band) {
        const double centre = std::pow(10.0, 0.1 * (4.0 + static_cast<double>(band)));
        const double half = std::pow(10.0, 0.05);
        const double level = 10.0 * std::log10(variance(iso3095_psd_m3, centre / half, centre * half) / 1e-12);
        // A power law of slope −3 averages over a third-octave to 0.03 dB above its centre; the bend at 31.5 mm adds
        // to that (both computed independently with SciPy: at most 0.065 dB, 0.155 dB in the band of the bend).
        EXPECT_NEAR(level, levels[band], band == 11 ? 0.16 : 0.07) << "band " << band;
    }
}

TEST(Iso3095, OuterSlopesAreContinued) {
    // The first two centres are 0.1 in log10 apart; one tenth further out the level falls or rises by the same ratio.
    const double first = std::pow(10.0, 0.4), ratio = std::pow(10.0, 0.1);
    expect_relative(iso3095_psd_m3(first / ratio) / iso3095_psd_m3(first),
                    iso3095_psd_m3(first) / iso3095_psd_m3(first * ratio), rounding);
}

TEST(Table, LogLogInsideNothingOutside) {
    const std::vector<double> n = {0.1, 1.0, 10.0}, psd = {1e-4, 1e-7, 1e-8};
    EXPECT_DOUBLE_EQ(table_psd_m3(n, psd, 0.1), 1e-4);
    expect_relative(table_psd_m3(n, psd, 10.0), 1e-8, rounding);
    expect_relative(table_psd_m3(n, psd, std::sqrt(0.1)), std::sqrt(1e-4 * 1e-7), rounding);
    expect_relative(table_psd_m3(n, psd, std::sqrt(10.0)), std::sqrt(1e-7 * 1e-8), rounding);
    EXPECT_EQ(table_psd_m3(n, psd, 0.0999), 0.0);
    EXPECT_EQ(table_psd_m3(n, psd, 10.01), 0.0);
}

TEST(ValidWavelengths, ComeFromTheFamilyOrTheTable) {
    EXPECT_NEAR(valid_wavelengths({.family = Family::fra}).longest_m, 304.8, 1e-9);  // 1000 ft
    EXPECT_EQ(valid_wavelengths({.family = Family::power_law}).longest_m, std::numeric_limits<double>::infinity());
    const IrregularityBand table{
        .family = Family::table, .table_cycles_per_m = {0.02, 2.0}, .table_psd_m3 = {1e-5, 1e-9}};
    EXPECT_DOUBLE_EQ(valid_wavelengths(table).shortest_m, 0.5);
    EXPECT_DOUBLE_EQ(valid_wavelengths(table).longest_m, 50.0);
}

}  // namespace
}  // namespace railpem::spectra

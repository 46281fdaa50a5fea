#include "spectra/spectrum_families.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace railpem::spectra {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

// A spectrum per rad/m becomes one per cycle/m: S(n) dn = S(Ω) dΩ with Ω = 2πn.
double per_cycle(double psd_per_radian) {
    return two_pi * psd_per_radian;
}

double german_psd_m3(double coefficient_m_rad, double cycles_per_m) {
    constexpr double cut_off = 0.8246;
    constexpr double reference = 0.0206;
    const double omega2 = std::pow(two_pi * cycles_per_m, 2);
    return per_cycle(coefficient_m_rad * cut_off * cut_off /
                     ((omega2 + reference * reference) * (omega2 + cut_off * cut_off)));
}

// Straight line through (n1, s1) and (n2, s2) in log–log.
double log_log(double n1, double s1, double n2, double s2, double n) {
    return s1 * std::pow(n / n1, std::log(s2 / s1) / std::log(n2 / n1));
}

// ISO 3095:2013: limits in dB re 1e-6 m for the wavelengths 0.4, 0.315, … 0.00315 m (third-octaves, base ten).
constexpr std::array iso3095_levels_db = {17.1, 15.0, 13.0, 11.0, 9.0,  7.0,  4.9,  2.9,  0.9,  -1.1,  -3.2,
                                          -5.0, -5.6, -6.2, -6.8, -7.4, -8.0, -8.6, -9.2, -9.8, -10.4, -11.0};
constexpr int iso3095_bands = static_cast<int>(iso3095_levels_db.size());
constexpr double third_octave = 1.2589254117941673;  // 10^(1/10)

struct Iso3095Table {
    std::array<double, iso3095_bands> cycles_per_m, psd_m3;
};

Iso3095Table iso3095_table() {
    Iso3095Table table{};
    for (int band = 0; band < iso3095_bands; ++band) {
        const double centre = std::pow(10.0, 0.1 * (4 + band));  // 10^0.4 cycles/m is 0.398 m
        const double width = centre * (std::sqrt(third_octave) - 1.0 / std::sqrt(third_octave));
        table.cycles_per_m[band] = centre;
        table.psd_m3[band] = 1e-12 * std::pow(10.0, 0.1 * iso3095_levels_db[band]) / width;
    }
    return table;
}

}  // namespace

double fra_psd_m3(int track_class, double cycles_per_m) {
    assert(track_class >= 1 && track_class <= 6 && cycles_per_m > 0.0);
    constexpr std::array roughness_cm2_rad_per_m = {1.2107, 1.0181, 0.6816, 0.5376, 0.2095, 0.0339};
    constexpr double k = 0.25;
    constexpr double critical = 0.8245;
    constexpr double square_metres_per_square_centimetre = 1e-4;
    const double omega2 = std::pow(two_pi * cycles_per_m, 2);
    const double psd_cm2 = k * roughness_cm2_rad_per_m[static_cast<std::size_t>(track_class - 1)] * critical *
                           critical / (omega2 * (omega2 + critical * critical));
    return per_cycle(square_metres_per_square_centimetre * psd_cm2);
}

double power_law_psd_m3(double coefficient_m3, double exponent, double cycles_per_m) {
    return coefficient_m3 * std::pow(cycles_per_m, -exponent);
}

double german_low_psd_m3(double cycles_per_m) {
    return german_psd_m3(4.032e-7, cycles_per_m);
}

double german_high_psd_m3(double cycles_per_m) {
    return german_psd_m3(1.080e-6, cycles_per_m);
}

double chinese_ballastless_psd_m3(double cycles_per_m) {
    struct Section {
        double upper_end_cycles_per_m, coefficient, exponent;
    };
    constexpr std::array<Section, 4> sections = {{{0.0187, 1.0544e-5, 3.3891},
                                                  {0.0474, 3.5588e-3, 1.9271},
                                                  {0.1533, 1.9784e-2, 1.3643},
                                                  {std::numeric_limits<double>::infinity(), 3.9488e-4, 3.4516}}};
    constexpr double square_metres_per_square_millimetre = 1e-6;
    const auto section = std::find_if(sections.begin(), sections.end(), [&](const Section& candidate) {
        return cycles_per_m < candidate.upper_end_cycles_per_m;
    });
    assert(section != sections.end());
    return square_metres_per_square_millimetre * section->coefficient * std::pow(cycles_per_m, -section->exponent);
}

double iso3095_psd_m3(double cycles_per_m) {
    static const Iso3095Table table = iso3095_table();
    const auto& n = table.cycles_per_m;
    // The pair of centres around n; outside the table the outermost pair, whose line is continued.
    const auto above = std::upper_bound(n.begin() + 1, n.end() - 1, cycles_per_m);
    const auto i = static_cast<std::size_t>(above - n.begin());
    return log_log(n[i - 1], table.psd_m3[i - 1], n[i], table.psd_m3[i], cycles_per_m);
}

double table_psd_m3(std::span<const double> table_cycles_per_m, std::span<const double> psd_m3, double cycles_per_m) {
    assert(table_cycles_per_m.size() >= 2 && table_cycles_per_m.size() == psd_m3.size());
    const auto n = table_cycles_per_m;
    if (cycles_per_m < n.front() || cycles_per_m > n.back()) return 0.0;
    const auto above = std::upper_bound(n.begin() + 1, n.end() - 1, cycles_per_m);
    const auto i = static_cast<std::size_t>(above - n.begin());
    return log_log(n[i - 1], psd_m3[i - 1], n[i], psd_m3[i], cycles_per_m);
}

WavelengthRange valid_wavelengths(const IrregularityBand& band) {
    constexpr double foot_m = 0.3048;
    switch (band.family) {
        case Family::fra:
            return {5.0 * foot_m, 1000.0 * foot_m};
        case Family::german_low:
        case Family::german_high:
            return {3.0, 150.0};
        case Family::chinese_ballastless:
            return {2.0, 200.0};
        case Family::iso3095:
            return {0.00315, 0.4};
        case Family::table:
            return {1.0 / band.table_cycles_per_m.back(), 1.0 / band.table_cycles_per_m.front()};
        case Family::power_law:
        case Family::profile:
            break;
    }
    return {0.0, std::numeric_limits<double>::infinity()};
}

}  // namespace railpem::spectra

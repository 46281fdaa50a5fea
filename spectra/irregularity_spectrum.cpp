#include "spectra/irregularity_spectrum.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include "spectra/spectrum_families.hpp"

namespace railpem::spectra {

namespace {

double family_psd_m3(const IrregularityBand& band, double cycles_per_m) {
    switch (band.family) {
        case Family::fra:
            return fra_psd_m3(band.fra_class, cycles_per_m);
        case Family::power_law:
            return power_law_psd_m3(band.coefficient_m3, band.exponent, cycles_per_m);
        case Family::german_low:
            return german_low_psd_m3(cycles_per_m);
        case Family::german_high:
            return german_high_psd_m3(cycles_per_m);
        case Family::chinese_ballastless:
            return chinese_ballastless_psd_m3(cycles_per_m);
        case Family::iso3095:
            return iso3095_psd_m3(cycles_per_m);
        case Family::table:
            return table_psd_m3(band.table_cycles_per_m, band.table_psd_m3, cycles_per_m);
        case Family::profile:
            break;  // a table by the time it has passed check()
    }
    assert(false);
    return 0.0;
}

// 10^(level/10)·(λ/λ_ref)^(slope/(10·log10 2)): per octave of wavelength the spectrum rises by the slope in dB.
double correction(const IrregularityParameters& irregularity, double cycles_per_m) {
    if (irregularity.level_db == 0.0 && irregularity.slope_db_per_octave == 0.0) return 1.0;
    constexpr double reference_wavelength_m = 3.0;
    const double octaves = -std::log2(cycles_per_m * reference_wavelength_m);
    return std::pow(10.0, 0.1 * (irregularity.level_db + irregularity.slope_db_per_octave * octaves));
}

double corrugation_psd_m3(const Corrugation& corrugation, double cycles_per_m) {
    const double centre = 1.0 / corrugation.wavelength_m;
    const double deviation = corrugation.relative_bandwidth * centre;
    const double distance = (cycles_per_m - centre) / deviation;
    // Only n > 0 exists: the Gaussian is normalised by its part there, so that the integral is rms² at any bandwidth.
    const double above_zero = 0.5 * std::erfc(-1.0 / (std::numbers::sqrt2 * corrugation.relative_bandwidth));
    return corrugation.rms_m * corrugation.rms_m * std::exp(-0.5 * distance * distance) /
           (std::sqrt(2.0 * std::numbers::pi) * deviation * above_zero);
}

}  // namespace

double band_psd_m3(const IrregularityBand& band, double cycles_per_m) {
    assert(cycles_per_m > 0.0);
    const double wavelength_m = 1.0 / cycles_per_m;
    // Half open, so that bands which meet at a wavelength do not count twice there.
    if (!(wavelength_m >= band.shortest_wavelength_m && wavelength_m < band.longest_wavelength_m)) return 0.0;
    return family_psd_m3(band, cycles_per_m);
}

double irregularity_psd_m3(const IrregularityParameters& irregularity, double cycles_per_m) {
    double sum = 0.0;
    for (const IrregularityBand& band : irregularity.bands) sum += band_psd_m3(band, cycles_per_m);
    if (sum > 0.0) sum *= correction(irregularity, cycles_per_m);
    if (!irregularity.wave_correction.empty()) sum *= irregularity.wave_correction.at(1.0 / cycles_per_m);
    for (const Corrugation& corrugation : irregularity.corrugation)
        sum += corrugation_psd_m3(corrugation, cycles_per_m);
    return sum;
}

double irregularity_psd_m2_per_hz(const IrregularityParameters& irregularity, double frequency_hz,
                                  double speed_m_per_s) {
    assert(frequency_hz > 0.0 && speed_m_per_s > 0.0);
    const double psd = irregularity_psd_m3(irregularity, frequency_hz / speed_m_per_s) / speed_m_per_s;
    if (irregularity.frequency_correction.empty()) return psd;
    return psd * irregularity.frequency_correction.at(frequency_hz);
}

}  // namespace railpem::spectra

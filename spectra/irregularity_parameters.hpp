#pragma once
// The vertical irregularity of the running surface as data. Spectra are one-sided in cycles/m, S(n) in m²/(cycle/m) =
// m³.

#include <string>
#include <vector>

#include "parameters/field.hpp"
#include "spectra/log_spline.hpp"

namespace railpem::spectra {

enum class Family { fra, power_law, german_low, german_high, chinese_ballastless, iso3095, table, profile };

/// One family over one band of wavelengths; outside the band it is nothing. Bands add where they overlap.
struct IrregularityBand {
    Family family = Family::fra;
    double shortest_wavelength_m = 1.0;
    double longest_wavelength_m = 100.0;
    int fra_class = 6;            ///< fra: track class 1 (worst) to 6 (best)
    double coefficient_m3 = 0.0;  ///< power_law: S(n) = coefficient·(n·1 m)^(−exponent)
    double exponent = 0.0;
    std::vector<double> table_cycles_per_m;  ///< table: increasing, log–log interpolation, nothing outside
    std::vector<double> table_psd_m3;
    /// table, profile: the measurement as a file; whoever reads the case turns it into the columns above.
    std::string file;
    /// profile: of the spectrum's estimate, spectrum_of_profile(); 0: an eighth of the profile
    double segment_length_m = 0.0;

    bool operator==(const IrregularityBand&) const = default;
};

/// A narrow band in wavelength: Gaussian in n around 1/wavelength, relative standard deviation `relative_bandwidth`,
/// whose integral is rms². The same for all wheels (part of the irregularity).
struct Corrugation {
    double wavelength_m = 0.3;
    double relative_bandwidth = 0.1;
    double rms_m = 20e-6;

    bool operator==(const Corrugation&) const = default;
};

/// Dips at a regular distance: each a raised cosine of depth h and length l, −h/2·(1 + cos(2πx/l)) for |x| < l/2.
/// Lines at n·v/spacing. The same for all wheels (part of the irregularity).
struct RailJoints {
    double spacing_m = 25.0;
    double depth_m = 0.5e-3;
    double length_m = 1.0;

    bool operator==(const RailJoints&) const = default;
};

struct IrregularityParameters {
    std::vector<IrregularityBand> bands;
    /// Correction of the broadband spectrum: 10^(level/10)·(λ/λ_ref)^(slope/(10·log10 2)), λ_ref = 3 m: level in dB at
    /// 3 m and slope in dB per octave of wavelength (positive: long waves stronger).
    double level_db = 0.0;
    double slope_db_per_octave = 0.0;
    std::vector<Corrugation> corrugation;
    std::vector<RailJoints> joints;
    /// factor on the broadband power spectrum; free correction of a diagnosis, 1 when empty
    LogSpline wave_correction;
    /// Factor on the power spectrum in time, corrugation included; free correction of a diagnosis, 1 when empty.
    LogFrequencySpline frequency_correction;

    bool operator==(const IrregularityParameters&) const = default;
};

parameters::Fields<IrregularityParameters> irregularity_fields();
parameters::Fields<IrregularityBand> irregularity_band_fields();
parameters::Fields<Corrugation> corrugation_fields();
parameters::Fields<RailJoints> rail_joint_fields();

/// The key of an element of a list as errors name it, counted from 1: "irregularity.band[2]" for ("band", 1).
std::string element_key(const std::string& list, std::size_t index);

/// Rules between parameters. Throws parameters::ParameterError (keys "irregularity.…").
void check(const IrregularityParameters& irregularity);

}  // namespace railpem::spectra

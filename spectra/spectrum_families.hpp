#pragma once
// The published families of vertical irregularity spectra, one-sided in cycles/m: S(n) in m²/(cycle/m) = m³.
// Every function evaluates its law at any n > 0; where the law was measured says valid_wavelengths().

#include <span>

#include "spectra/irregularity_parameters.hpp"

namespace railpem::spectra {

/// FRA line grade spectrum, vertical profile, track class 1 (worst) to 6 (best), in m³ at n cycles/m:
/// S(Ω) = k·A_v·Ω_c²/(Ω²(Ω² + Ω_c²)) in cm²/(rad/m), k = 0.25, Ω_c = 0.8245 rad/m (Hamid & Yang 1981), one-sided.
double fra_psd_m3(int track_class, double cycles_per_m);

/// S(n) = coefficient·(n·1 m)^(−exponent), in m³. Short waves between Shijiazhuang and Taiyuan: 3.6e-8 m³ and 3.15
/// (Wei et al. 2016, eq. 9).
double power_law_psd_m3(double coefficient_m3, double exponent, double cycles_per_m);

/// German spectra of low and high disturbance, vertical profile, in m³ at n cycles/m (ORE B176 1989; Claus & Schiehlen
/// 1998): S(Ω) = A·Ω_c²/((Ω² + Ω_r²)(Ω² + Ω_c²)) in m²/(rad/m), Ω_c = 0.8246 rad/m, Ω_r = 0.0206 rad/m,
/// A = 4.032e-7 m·rad (low) and 1.080e-6 m·rad (high). Read as one-sided; README.md says why.
double german_low_psd_m3(double cycles_per_m);
double german_high_psd_m3(double cycles_per_m);

/// Chinese ballastless high-speed track, vertical profile, mean spectrum (TB/T 3352-2014, 300 to 350 km/h), in m³ at
/// n cycles/m: A/n^k in mm²/(1/m) in four sections of n, joined at 0.0187, 0.0474 and 0.1533 1/m.
double chinese_ballastless_psd_m3(double cycles_per_m);

/// Upper limit of the acoustic roughness of the rail (ISO 3095:2013, third-octave levels re 1e-6 m over wavelength) as
/// a spectrum in m³ at n cycles/m: mean square of a band divided by its width, placed at the band's exact centre and
/// interpolated in log–log. Integrated over a band it gives the level back within 0.07 dB (0.16 dB in the band of
/// 31.5 mm, where the limit bends). Beyond the first and the last band the slope of the limit there is continued.
double iso3095_psd_m3(double cycles_per_m);

/// Log–log interpolation in a table of increasing n and positive S(n); 0 outside the table.
double table_psd_m3(std::span<const double> table_cycles_per_m, std::span<const double> psd_m3, double cycles_per_m);

/// Wavelengths over which a family is defined by its source; for information, the band's own limits rule.
struct WavelengthRange {
    double shortest_m = 0.0;
    double longest_m = 0.0;
};

/// 0 to infinity for a power law, whose range depends on its coefficients; the ends of the table for a table.
WavelengthRange valid_wavelengths(const IrregularityBand& band);

}  // namespace railpem::spectra

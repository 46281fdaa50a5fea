#pragma once

#include "spectra/irregularity_parameters.hpp"

namespace railpem::spectra {

/// One-sided spectrum of one band at n cycles/m, in m³; zero outside its wavelengths. n > 0.
double band_psd_m3(const IrregularityBand& band, double cycles_per_m);

/// One-sided broadband spectrum of the irregularity at n cycles/m, in m³: all bands with level, slope and
/// wave_correction, plus corrugation. Joints are lines and not part of it. n > 0.
double irregularity_psd_m3(const IrregularityParameters& irregularity, double cycles_per_m);

/// The same at speed v as a spectrum in time, m²/Hz: S(f) = S(n)/v at n = f/v (f > 0, v > 0), with
/// frequency_correction.
double irregularity_psd_m2_per_hz(const IrregularityParameters& irregularity, double frequency_hz,
                                  double speed_m_per_s);

}  // namespace railpem::spectra

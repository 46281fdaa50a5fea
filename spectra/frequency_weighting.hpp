#pragma once
// How strongly people feel vertical acceleration of a frequency: magnitudes of the weightings, f in Hz, f ≥ 0.

namespace railpem::spectra {

/// W_k of ISO 2631-1:1997 (vertical, seated or standing; filter parameters as in ISO 8041): band limits 0.4 and 100 Hz,
/// transition at 12.5 Hz (Q 0.63), step from 2.37 Hz (Q 0.91) to 3.35 Hz (Q 0.91). Agrees with the tabulated
/// values for 0.5 to 80 Hz within one unit of their last digit.
double weighting_wk(double frequency_hz);

/// W_b of EN 12299:2009 (vertical; other quality factors than the W_b of ISO 2631-4): band limits 0.4 and 100 Hz,
/// transition at 16 Hz (Q 0.63), step from 2.5 Hz (Q 0.8) to 4 Hz (Q 0.8), gain 0.4 at low frequencies.
double weighting_wb(double frequency_hz);

/// B of Sperling's ride index for comfort, vertical (Sperling & Betzhold 1956; Garg & Dukkipati 1984):
/// B = 0.588·√((1.911 f² + (0.25 f²)²)/((1 − 0.277 f²)² + (1.563 f − 0.0368 f³)²)). For 0.5 to 30 Hz.
double weighting_sperling_vertical(double frequency_hz);

}  // namespace railpem::spectra

#pragma once
// Third-octave bands of IEC 61260-1:2014, base ten: centre 10^(i/10) Hz, edges 10^((i ± 1/2)/10) Hz.

#include <span>
#include <vector>

namespace railpem::spectra {

struct ThirdOctaveBand {
    int index = 0;            ///< 0 for 1 Hz, 10 for 10 Hz, −5 for 0.315 Hz
    double nominal_hz = 0.0;  ///< as it is called: 1, 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8 and decades of them
    double centre_hz = 0.0;   ///< exact mid-band frequency
    double low_hz = 0.0;
    double high_hz = 0.0;
};

/// The band with centre 10^(index/10) Hz.
ThirdOctaveBand third_octave_band(int index);

/// All bands that lie wholly between low_hz > 0 and high_hz, in increasing order.
std::vector<ThirdOctaveBand> third_octave_bands(double low_hz, double high_hz);

struct ThirdOctaveLevel {
    ThirdOctaveBand band;
    double mean_square = 0.0;  ///< ∫S df over the band
    double level_db = 0.0;     ///< 10·log10(mean square/reference²); −infinity for nothing
};

/// Acceleration levels are given re 1e-6 m/s² (ISO 1683).
inline constexpr double reference_acceleration_m_per_s2 = 1e-6;

/// 10·log10(mean square/reference²), dB.
double level_db(double mean_square, double reference = reference_acceleration_m_per_s2);

/// Levels of a one-sided PSD on an increasing grid (linear between its lines, frequencies > 0). Bands that the grid
/// does not cover from edge to edge have no level and are left out.
std::vector<ThirdOctaveLevel> third_octave_levels(std::span<const double> frequency_hz, std::span<const double> psd,
                                                  double reference = reference_acceleration_m_per_s2);

}  // namespace railpem::spectra

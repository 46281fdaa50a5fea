#pragma once
// From a measured profile of the running surface to a spectrum that a case can use.

#include <span>
#include <vector>

#include "spectra/irregularity_parameters.hpp"

namespace railpem::spectra {

/// Estimated one-sided spectrum of a profile.
struct ProfileSpectrum {
    std::vector<double> cycles_per_m;  ///< uniform, from two cycles per segment to below the Nyquist frequency
    std::vector<double> psd_m3;
    double segment_length_m = 0.0;  ///< as used: the asked-for one rounded down to a quick length of the transform
    int segments = 0;               ///< overlapping by half
    double averages = 0.0;  ///< equivalent number of independent segments: relative variance of a value is 1/averages
};

/// Welch's estimate (1967): segments overlapping by half, their straight line removed, Hann window, mean of the
/// periodograms. Resolution is about 1.5/segment length; the line at one cycle per segment is left out because the
/// removal of the straight line takes power from it. `position_m` increases in even steps (each within 1 % of the mean
/// step, so that uneven spacing does not matter at wavelengths above 10 steps), `height_m` is of the same length.
/// Throws parameters::ParameterError (key "irregularity.profile") for uneven positions, values that are not finite, a
/// segment of fewer than 16 samples or longer than the profile, or a profile that does not vary.
ProfileSpectrum spectrum_of_profile(std::span<const double> position_m, std::span<const double> height_m,
                                    double segment_length_m);

/// The estimate as a band of the family `table`, with the wavelengths that it covers.
IrregularityBand measured_band(const ProfileSpectrum& spectrum);

}  // namespace railpem::spectra

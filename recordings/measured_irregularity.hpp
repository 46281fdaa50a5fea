#pragma once
// The irregularity of the running surface as a user brings it: a spectrum in space, or a profile.

#include <string>
#include <vector>

#include "recordings/files/data_table.hpp"

namespace railpem::recordings {

/// Either table: a measured spectrum, or a measured profile and the spectrum estimated from it.
struct MeasuredIrregularity {
    std::string file;                  ///< empty: nothing was brought
    std::vector<double> cycles_per_m;  ///< increasing, greater than 0
    std::vector<double> psd_m3;        ///< one-sided, greater than 0; of a profile the estimate (not less than 0)
    std::vector<double> position_m;    ///< profile only: increasing in even steps
    std::vector<double> height_m;      ///< profile only: up positive, as in the file
    double segment_length_m = 0.0;     ///< profile only: of the estimate, spectra::spectrum_of_profile()
    double averages = 0.0;             ///< profile only: relative variance of a value of psd_m3 is 1/averages

    bool brought() const { return !file.empty(); }
    bool is_profile() const { return !height_m.empty(); }
    double shortest_wavelength_m() const { return 1.0 / cycles_per_m.back(); }
    double longest_wavelength_m() const { return 1.0 / cycles_per_m.front(); }
};

/// A CSV with the columns `cycles_per_m` and `psd_m3`: strictly increasing, both greater than 0, at least two rows.
/// Throws ReadError with the line.
MeasuredIrregularity read_irregularity_spectrum(const std::string& file, const ReadLimits& limits = {});

/// A CSV with the columns `position_m` and `height_m`: positions that increase in steps within 1 % of their mean, and
/// heights that vary, long enough for segments of 16 steps. `segment_length_m`: of the spectrum's estimate; 0: an
/// eighth of the profile (15 segments with their overlap, 27 % standard error per value). Throws ReadError with the
/// line.
MeasuredIrregularity read_irregularity_profile(const std::string& file, double segment_length_m = 0.0,
                                               const ReadLimits& limits = {});

/// Whichever of the two the columns of the file say. Throws ReadError.
MeasuredIrregularity read_irregularity(const std::string& file, const ReadLimits& limits = {});

}  // namespace railpem::recordings

#pragma once

#include <vector>

#include "recordings/estimates/confidence.hpp"
#include "recordings/estimates/cross_spectra.hpp"
#include "spectra/third_octaves.hpp"

namespace railpem::recordings {

/// Level of one channel in one third-octave band, with its interval.
struct BandLevel {
    spectra::ThirdOctaveBand band;
    double level_db = 0.0;  ///< re 1e-6 of the SI unit
    Interval interval_db;   ///< 90 %, χ² with 2·averages degrees of freedom
    double averages = 0.0;  ///< independent averages of the band, from window, overlap and the spectrum's shape in it
};

/// Third-octave levels of a channel in its own quantity; bands narrower than three bins are left out.
std::vector<BandLevel> band_levels(const CrossSpectra& spectra, std::size_t channel);

}  // namespace railpem::recordings

#pragma once

#include <vector>

#include "recordings/inspection/inspection_report.hpp"

namespace railpem::recordings {

/// Spectrograms of up to three channels, the roughest of each location: windows so chosen that a picture has at most
/// about 400 by 300 points, frequencies up to 0.4 of the sampling rate or 500 Hz.
std::vector<Spectrogram> spectrograms_of(const TimeSeries& series);

}  // namespace railpem::recordings

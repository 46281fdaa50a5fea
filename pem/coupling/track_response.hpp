#pragma once
// The track without a vehicle, at rest, as a hammer test sees it.

#include <complex>
#include <vector>

#include "pem/case_parameters.hpp"

namespace railpem::pem {

/// Point receptances over a support and in the middle of a bay, m/N, and what is needed for decay rates, per line.
struct TrackResponse {
    std::vector<double> frequency_hz;
    std::vector<std::complex<double>> over_pad, mid_bay;
    std::vector<double> bloch_decay_db_per_m;
    /// |transfer accelerance|² per unit force, force in the middle of a bay: [line][position of EN 15461].
    std::vector<std::vector<double>> squared_transfer;
};

/// Track decay rate in a third-octave.
struct DecayBand {
    double centre_hz;
    double decay_rate_db_per_m;        ///< EN 15461, from transfer functions averaged over the band
    double bloch_decay_rate_db_per_m;  ///< mean over the lines of the band
};

/// `lines` frequencies from `from_hz` to `to_hz` in geometric progression.
std::vector<double> geometric_lines(double from_hz, double to_hz, int lines);

/// Infinite uniform track of unloaded pads at the given frequencies (> 0). `with_decay`: also the transfer functions of
/// EN 15461.
TrackResponse track_response(const CaseParameters& parameters, const std::vector<double>& frequency_hz, bool with_decay,
                             int threads = 0);

/// Decay rates of all third-octaves that hold at least three lines. `centres_hz` with band edges centre·10^(±1/20).
std::vector<DecayBand> decay_bands(const TrackResponse& response, const std::vector<double>& centres_hz,
                                   double spacing_m);

}  // namespace railpem::pem

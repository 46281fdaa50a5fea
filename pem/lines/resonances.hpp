#pragma once
// Where the spectra of a case have peaks, and how wide they are.

#include <string>
#include <vector>

#include "pem/coupling/prepared_case.hpp"

namespace railpem::pem {

/// A peak of the transfer functions, or a spectral line of the excitation (a tooth).
struct Resonance {
    std::string name;  ///< in words: "body bounce", "wheel on the track", "line of joints"
    double frequency_hz = 0.0;
    double width_hz = 0.0;       ///< between the half-power points: 2ζf, or 2.355 standard deviations of a tooth
    double damping_ratio = 0.0;  ///< ζ; half of width over frequency for a tooth
};

/// Natural motions of body and bogies on primary, secondary and the static track, and of the wheel on the track: where
/// wheel 1 moves most per irregularity under it, between twice its frequency on the primary spring and 500 Hz. By
/// increasing frequency.
std::vector<Resonance> natural_resonances(const PreparedCase& prepared);

/// Spectral lines of the excitation and corrugations, by increasing frequency.
std::vector<Resonance> excitation_teeth(const CaseParameters& parameters, const PreparedCase& prepared);

}  // namespace railpem::pem

#pragma once
// Frequency lines close enough for what is integrated over them.

#include <vector>

#include "pem/lines/resonances.hpp"

namespace railpem::pem {

/// Spectra on lines that may stand at any distance: PSDs are linear between them.
struct RefinedSpectra {
    std::vector<double> frequency_hz;
    std::vector<std::vector<double>> psd;  ///< [response of response_names()][line]
    bool converged = true;
    double doubtful_hz = 0.0;  ///< where it has not converged
};

/// Lines to begin with: those given, none further from the next than a quarter of the period over which the delays of
/// the wheels repeat themselves (v over the distance of the outermost wheels) or half an octave; between them lines at
/// and around every resonance and tooth and at the edges of the bands of wavelengths, where the lines are coarser than
/// these.
std::vector<double> starting_lines(const CaseParameters& parameters, const PreparedCase& prepared,
                                   const std::vector<double>& given);

/// Halves intervals until trapezoids give the mean square of every response in every third-octave within 1 %, by the
/// curvature between the lines. Lines of `start` are kept. Not converged: a peak is narrower than a millionth of its
/// frequency, or more than 60000 lines would be needed.
RefinedSpectra refine_lines(const CaseParameters& parameters, const PreparedCase& prepared, const Solution& start,
                            const SolveOptions& options = {});

}  // namespace railpem::pem

#pragma once
// Responses of a case at one speed.

#include <complex>
#include <string>
#include <vector>

#include "pem/linearisation.hpp"
#include "pem/response_names.hpp"

namespace railpem::pem {

/// The pseudo-response vectors of one speed: for source s, response r and line l the complex amplitude
/// y = H(ω)·e(ω)·√S(ω), in (m/s²)/√Hz or N/√Hz. The cross-spectral matrix is Σ_s y_s y_sᴴ.
struct Solution {
    double speed_m_per_s = 0.0;
    std::vector<double> frequency_hz;
    std::vector<std::string> source_names;              ///< "irregularity", "wheel_1", …
    std::vector<std::complex<double>> pseudo_response;  ///< [source][response][line]
    std::vector<std::string> warnings;                  ///< validity of what was computed, in words
    Linearisation linearisation;                        ///< of friction and contact; all zero for a linear case

    const std::complex<double>* at(std::size_t source, std::size_t response) const {
        return pseudo_response.data() + (source * response_names().size() + response) * frequency_hz.size();
    }
};

/// One-sided PSD of a response, summed over the sources: (m/s²)²/Hz or N²/Hz, one value per line.
std::vector<double> response_psd(const Solution& solution, std::size_t response);

}  // namespace railpem::pem

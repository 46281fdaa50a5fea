#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "pem/case_parameters.hpp"
#include "pem/linearisation.hpp"

namespace railpem::pem {

enum class Quantity { acceleration, force };

/// One observed response. `where`: body (centre), body_front, body_rear (over the pivots), bogie_1, bogie_2,
/// wheel_1 … wheel_4, rail_1 … rail_4 (rail under wheel n), contact_1 … contact_4, trackbed.
struct ResponseName {
    std::string where;
    Quantity quantity;
};

/// All responses in the order of the tables.
const std::vector<ResponseName>& response_names();
/// Index in response_names(); asserts that it exists.
std::size_t response_index(const std::string& where);

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

/// Thrown instead of a result that somebody no longer wants.
struct Interrupted {};

struct SolveOptions {
    int threads = 0;  ///< 0: as many as OpenMP offers
    /// Called now and then from one thread with lines done and lines in all.
    std::function<void(std::size_t, std::size_t)> progress;
    /// Asked between lines, from several threads at a time; true ends the solution with Interrupted.
    std::function<bool()> interrupted;
};

/// Frequency lines of the grid, Hz.
std::vector<double> frequency_lines(const FrequencyParameters& grid);

/// Solves the case at one speed on its own frequency grid. `parameters` must have passed check().
Solution solve_case(const CaseParameters& parameters, double speed_m_per_s, const SolveOptions& options = {});

/// One-sided PSD of a response, summed over the sources: (m/s²)²/Hz or N²/Hz, one value per line.
std::vector<double> response_psd(const Solution& solution, std::size_t response);

}  // namespace railpem::pem

#pragma once
// A case at one speed, ready to be solved on any frequency lines.

#include <string>
#include <vector>

#include "pem/case_parameters.hpp"
#include "pem/coupling/coupled_model.hpp"
#include "pem/coupling/excitation.hpp"
#include "pem/coupling/solution.hpp"
#include "pem/solve_options.hpp"

namespace railpem::pem {

/// A source, and where its spectral lines lie.
struct PreparedSource {
    Source source;
    std::vector<double> teeth_hz;  ///< increasing; nothing for a broadband source
};

/// What does not depend on the lines: the linearised model, what excites it, and what was warned of on the way.
struct PreparedCase {
    double speed_m_per_s = 0.0;
    CoupledModel model;
    std::vector<PreparedSource> sources;
    Linearisation linearisation;
    std::vector<std::string> warnings;
};

/// `parameters` must have passed check(). Throws parameters::ParameterError without a static equilibrium.
PreparedCase prepare_case(const CaseParameters& parameters, double speed_m_per_s);

/// Frequency lines in Hz, increasing, and the bin [f − below, f + above] that each stands for.
struct FrequencyLines {
    std::vector<double> frequency_hz, below_hz, above_hz;
};

/// Bins that end half way to the neighbours; the outermost are symmetric about their line. At least two lines.
FrequencyLines with_bins(std::vector<double> frequency_hz);

/// All responses on these lines, which need not be neighbours. `warnings` are those of the preparation.
Solution solve_lines(const CaseParameters& parameters, const PreparedCase& prepared, const FrequencyLines& lines,
                     const SolveOptions& options = {});

}  // namespace railpem::pem

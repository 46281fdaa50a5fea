#pragma once
// All responses of a case at one speed, lines in parallel.

#include "pem/case_parameters.hpp"
#include "pem/coupling/solution.hpp"
#include "pem/solve_options.hpp"

namespace railpem::pem {

/// Solves the case at one speed on its own frequency lines, whatever they resolve. `parameters` must have passed
/// check().
Solution solve_case(const CaseParameters& parameters, double speed_m_per_s, const SolveOptions& options = {});

}  // namespace railpem::pem

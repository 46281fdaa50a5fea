#include "pem/coupling/solve_case.hpp"

#include "pem/coupling/prepared_case.hpp"

namespace railpem::pem {

Solution solve_case(const CaseParameters& parameters, double speed_m_per_s, const SolveOptions& options) {
    return solve_lines(parameters, prepare_case(parameters, speed_m_per_s),
                       with_bins(frequency_lines(parameters.frequency)), options);
}

}  // namespace railpem::pem

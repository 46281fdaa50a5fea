#include "pem/coupling/solution.hpp"

namespace railpem::pem {

std::vector<double> response_psd(const Solution& solution, std::size_t response) {
    std::vector<double> psd(solution.frequency_hz.size());
    for (std::size_t s = 0; s < solution.source_names.size(); ++s) {
        const std::complex<double>* row = solution.at(s, response);
        for (std::size_t line = 0; line < psd.size(); ++line) psd[line] += std::norm(row[line]);
    }
    return psd;
}

}  // namespace railpem::pem

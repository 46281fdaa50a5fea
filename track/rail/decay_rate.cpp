#include "track/rail/decay_rate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace railpem::track {

std::vector<double> decay_rate_positions_m(double spacing_m) {
    std::vector<double> positions;
    for (const double bays : {0.0, 0.25, 0.5, 0.75, 1.0,  1.25, 1.5,  1.75, 2.0,  2.25, 2.5,  3.0,  3.5,  4.0, 5.0,
                              6.0, 7.0,  8.0, 10.0, 12.0, 16.0, 20.0, 24.0, 30.0, 36.0, 42.0, 48.0, 54.0, 66.0})
        positions.push_back(bays * spacing_m);
    return positions;
}

double decay_rate_db_per_m(const std::vector<double>& positions_m, const std::vector<double>& squared) {
    assert(positions_m.size() == squared.size() && positions_m.size() >= 2);
    double sum = 0.0;
    for (std::size_t n = 0; n < positions_m.size(); ++n) {
        const double before = n > 0 ? positions_m[n - 1] : positions_m[n];
        const double after = n + 1 < positions_m.size() ? positions_m[n + 1] : positions_m[n];
        sum += squared[n] / squared[0] * 0.5 * (after - before);
    }
    return 10.0 * std::log10(std::exp(1.0)) / sum;
}

double bloch_decay_rate_db_per_m(std::complex<double> factor_1, std::complex<double> factor_2, double spacing_m) {
    const double farthest = std::max(std::abs(factor_1), std::abs(factor_2));
    return -20.0 * std::log10(std::min(1.0, farthest)) / spacing_m;
}

}  // namespace railpem::track

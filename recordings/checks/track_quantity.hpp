#pragma once

#include <string>
#include <vector>

namespace railpem::recordings::checks {

/// What the values of a receptance are, by size and slope.
struct TrackQuantity {
    double factor = 1.0;    ///< value = factor × receptance in m/N, or its derivative in time
    int derivatives = 0;    ///< 1: mobility, 2: accelerance
    std::string says;       ///< "accelerance, (m/s^2)/N"; "" for a receptance in m/N
    double level_db = 0.0;  ///< median over what was expected of a receptance in m/N
};

/// `magnitude` at `frequency_hz` against a receptance that is expected to within `scatter_db` (one standard deviation).
TrackQuantity track_quantity(const std::vector<double>& frequency_hz, const std::vector<double>& magnitude,
                             const std::vector<double>& expected_m_per_n, double scatter_db);

}  // namespace railpem::recordings::checks

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace railpem::recordings::checks {

/// Between the values on an increasing grid; 0 outside.
inline double interpolated(const std::vector<double>& grid, const std::vector<double>& values, double at) {
    const auto above = std::lower_bound(grid.begin(), grid.end(), at);
    if (above == grid.end()) return 0.0;
    const auto i = static_cast<std::size_t>(above - grid.begin());
    if (grid[i] == at) return values[i];
    if (i == 0) return 0.0;
    const double share = (at - grid[i - 1]) / (grid[i] - grid[i - 1]);
    return values[i - 1] + share * (values[i] - values[i - 1]);
}

}  // namespace railpem::recordings::checks

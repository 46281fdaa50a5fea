#pragma once
// Interpolation of what is smooth over several lines of a uniform grid.

#include <array>
#include <cstddef>

namespace railpem::pem {

inline constexpr int kLagrangePoints = 6;

/// Lagrange weights at `place` among the points 0 … 5.
inline std::array<double, kLagrangePoints> lagrange(double place) {
    std::array<double, kLagrangePoints> weight;
    for (int i = 0; i < kLagrangePoints; ++i) {
        double product = 1.0;
        for (int j = 0; j < kLagrangePoints; ++j)
            if (j != i) product *= (place - j) / (i - j);
        weight[static_cast<std::size_t>(i)] = product;
    }
    return weight;
}

}  // namespace railpem::pem

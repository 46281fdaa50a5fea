#pragma once

#include <cmath>
#include <numbers>

namespace railpem::pem {

/// E[value(ξ)] for standard Gaussian ξ, a number or an array of them, by the midpoint rule over ±9: of smooth values to
/// rounding, and of those that bend at the end of a contact as well as their bend allows.
template <class Function>
auto gaussian_mean(Function&& value) {
    constexpr int kPoints = 800;
    auto sum = value(0.0);
    sum *= 0.0;
    for (int i = 0; i < kPoints; ++i) {
        const double xi = -9.0 + 18.0 * (i + 0.5) / kPoints;
        sum += value(xi) * std::exp(-0.5 * xi * xi);
    }
    sum *= 18.0 / kPoints / std::sqrt(2.0 * std::numbers::pi);
    return sum;
}

}  // namespace railpem::pem

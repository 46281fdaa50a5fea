#include "simulate/numerics/smooth_noise.hpp"

#include <cmath>
#include <numbers>

#include "simulate/numerics/random_numbers.hpp"

namespace railpem::simulate {

double smooth_noise_at(std::uint64_t seed, double place, double length) {
    constexpr double per_length = 4.0;  // grid points
    constexpr std::int64_t reach = 16;  // of the bell exp(−π/2·d²), in grid points: 1e-11 is left there
    const double at = place / length * per_length;
    const auto middle = static_cast<std::int64_t>(std::floor(at));
    double sum = 0.0;
    for (std::int64_t j = middle - reach + 1; j <= middle + reach; ++j) {
        const double distance = (at - static_cast<double>(j)) / per_length;
        sum += std::exp(-0.5 * std::numbers::pi * distance * distance) *
               normal_pair_at(seed, static_cast<std::uint64_t>(j)).first;
    }
    return sum / std::sqrt(per_length);
}

}  // namespace railpem::simulate

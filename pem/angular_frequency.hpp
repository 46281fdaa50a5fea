#pragma once
// From frequencies in Hz to ω in rad/s.

#include <algorithm>
#include <numbers>
#include <vector>

#include "lanes/complex_lanes.hpp"

namespace railpem::pem {

inline constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// ω of the lines of a group; lanes beyond the last line repeat it.
inline lanes::Real group_omega(const std::vector<double>& frequency_hz, std::size_t group) {
    lanes::Real omega{};
    for (std::size_t lane = 0; lane < lanes::width; ++lane)
        omega[lane] = kTwoPi * frequency_hz[std::min(group * lanes::width + lane, frequency_hz.size() - 1)];
    return omega;
}

}  // namespace railpem::pem

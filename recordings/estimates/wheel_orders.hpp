#pragma once

#include <optional>
#include <string>
#include <vector>

#include "recordings/estimates/spectral_lines.hpp"

namespace railpem::recordings {

/// Lines that are multiples of one frequency of rotation.
struct WheelOrders {
    double rotation_hz = 0.0;
    double rotation_error_hz = 0.0;  ///< standard error
    std::vector<int> orders;         ///< of the lines that fit
    std::size_t lines = 0;           ///< lines that were looked at
    double false_alarm = 1.0;        ///< that as many lines fit some rotation in the range by chance
};

/// The rotation of which most lines are multiples, among all that wheels of 0.30 to 0.65 m radius have at this speed (±
/// 3 %). Each line fits by chance with probability 2·tolerance/rotation; the binomial tail times the number of distinct
/// rotations tried is the false alarm. Lines of sleeper passing are no evidence for a wheel: with a spacing they are
/// left out, without one (0) all multiples of a line that sleepers 0.45 to 0.8 m apart may make count as one.
/// Nothing when fewer than three lines fit, when all are multiples of a higher order, or when chance explains them
/// (more than 1e-3).
std::optional<WheelOrders> wheel_orders_of(const std::vector<std::vector<SpectralLine>>& lines_of_channels,
                                           double speed_m_per_s, double sleeper_spacing_m = 0.0);

/// "wheel order 12", or "" when the frequency is no multiple of the rotation.
std::string name_by_rotation(double frequency_hz, const WheelOrders& orders);

}  // namespace railpem::recordings

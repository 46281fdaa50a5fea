#include "recordings/checks/line_names.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace railpem::recordings {
namespace {

/// The order of `base` nearest to f, or 0 when f is further from it than the speed's error and a tenth of a hertz
/// allow.
int order_of(double f, double base, double relative_error, int most) {
    const double order = std::round(f / base);
    if (order < 1.0 || order > most) return 0;
    const double tolerance = 0.1 + order * base * std::max(2.0 * relative_error, 1e-3);
    return tolerance < 0.25 * base && std::abs(f - order * base) <= tolerance ? static_cast<int>(order) : 0;
}

}  // namespace

std::string name_of_order(double frequency_hz, double speed_m_per_s, double speed_error_m_per_s,
                          const InspectionContext& context) {
    if (speed_m_per_s <= 0.0) return "";
    const double relative = speed_error_m_per_s / speed_m_per_s;
    std::string name;
    if (context.sleeper_spacing_m > 0.0)
        if (const int order = order_of(frequency_hz, speed_m_per_s / context.sleeper_spacing_m, relative, 6))
            name = order == 1 ? "sleeper passing" : fmt::format("sleeper passing, order {}", order);
    if (context.wheel_radius_m > 0.0)
        if (const int order =
                order_of(frequency_hz, speed_m_per_s / (2.0 * std::numbers::pi * context.wheel_radius_m), relative, 20))
            name += (name.empty() ? "" : " or ") + fmt::format("wheel order {}", order);
    return name;
}

std::string name_of_line(double frequency_hz, double speed_m_per_s, double speed_error_m_per_s,
                         const InspectionContext& context) {
    std::string name = name_of_order(frequency_hz, speed_m_per_s, speed_error_m_per_s, context);
    for (const double mains : {50.0, 60.0}) {
        const double multiple = std::round(frequency_hz / mains);
        if (multiple >= 1.0 && multiple <= 6.0 && std::abs(frequency_hz - multiple * mains) <= 0.06 * multiple)
            name += (name.empty() ? "" : " or ") + fmt::format("mains, {:.0f} × {:.0f} Hz", multiple, mains);
    }
    if (std::abs(frequency_hz - 16.683) <= 0.05)
        name += (name.empty() ? "" : " or ") + std::string("railway mains, 16.7 Hz");
    return name;
}

}  // namespace railpem::recordings

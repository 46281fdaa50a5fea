#include "recordings/inspection/named_frequencies.hpp"

#include <fmt/format.h>

#include <numbers>

namespace railpem::recordings {

std::vector<NamedFrequency> named_frequencies(double speed_m_per_s, double highest_hz,
                                              const InspectionContext& context) {
    std::vector<NamedFrequency> names;
    const auto add = [&](double frequency, std::string name) {
        if (frequency > 0.0 && frequency < highest_hz) names.push_back({frequency, std::move(name)});
    };
    const bool known = context.sleeper_spacing_m > 0.0;
    const double spacing = known ? context.sleeper_spacing_m : 0.6;
    for (int order = 1; order <= 3; ++order)
        add(order * speed_m_per_s / spacing,
            fmt::format("sleeper passing{}{}", order > 1 ? fmt::format(" ×{}", order) : "",
                        known ? "" : " (if 0.6 m)"));
    if (context.wheel_radius_m > 0.0)
        for (int order = 1; order <= 5; ++order)
            add(order * speed_m_per_s / (2.0 * std::numbers::pi * context.wheel_radius_m),
                fmt::format("wheel order {}", order));
    add(50.0, "mains 50 Hz");
    add(16.683, "railway mains 16.7 Hz");
    return names;
}

}  // namespace railpem::recordings

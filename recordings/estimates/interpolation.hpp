#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace railpem::recordings {

/// A channel at a time between its samples, in samples from the first: the cubic through the four nearest (Catmull &
/// Rom 1974); 0 outside.
inline double sample_at(const std::vector<double>& samples, double place) {
    const double whole = std::floor(place), t = place - whole;
    const auto i = static_cast<long>(whole);
    if (i < 1 || i + 2 >= static_cast<long>(samples.size())) return 0.0;
    const double a = samples[static_cast<std::size_t>(i - 1)], b = samples[static_cast<std::size_t>(i)],
                 c = samples[static_cast<std::size_t>(i + 1)], d = samples[static_cast<std::size_t>(i + 2)];
    return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

}  // namespace railpem::recordings

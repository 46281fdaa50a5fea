#include "recordings/stated_speed.hpp"

#include <algorithm>
#include <cmath>

namespace railpem::recordings {

StatedSpeed stated_speed(const Recording& recording) {
    const RecordingDescription& description = recording.description;
    const double stated = description.speed_m_per_s;
    if (stated > 0.0) return {stated, description.speed_standard_error_m_per_s, false, stated, stated};
    double sum = 0.0, square = 0.0, count = 0.0, lowest = 1e300, highest = 0.0;
    for (const double v : recording.series.speed_m_per_s)
        if (std::isfinite(v)) {
            sum += v;
            square += v * v;
            count += 1.0;
            lowest = std::min(lowest, v);
            highest = std::max(highest, v);
        }
    if (count == 0.0 || sum <= 0.0) return {0.0, description.speed_standard_error_m_per_s};
    const double mean = sum / count;
    const double scatter = std::sqrt(std::max(0.0, square / count - mean * mean));
    return {mean, std::max({scatter, 0.005 * mean, description.speed_standard_error_m_per_s}), true, lowest, highest};
}

}  // namespace railpem::recordings

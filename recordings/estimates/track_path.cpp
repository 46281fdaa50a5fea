#include "recordings/estimates/track_path.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace railpem::recordings {

double TrackPath::mean_m_per_s() const {
    return distance_m.back() / (step_s * static_cast<double>(speed_m_per_s.size() - 1));
}

double TrackPath::speed_at(double time) const {
    const double place = std::clamp(time / step_s, 0.0, static_cast<double>(speed_m_per_s.size() - 1));
    const auto i = std::min(static_cast<std::size_t>(place), speed_m_per_s.size() - 2);
    const double share = place - static_cast<double>(i);
    return (1.0 - share) * speed_m_per_s[i] + share * speed_m_per_s[i + 1];
}

double TrackPath::distance_at(double time) const {
    const double last = step_s * static_cast<double>(speed_m_per_s.size() - 1);
    if (time <= 0.0) return time * speed_m_per_s.front();
    if (time >= last) return distance_m.back() + (time - last) * speed_m_per_s.back();
    const auto i = std::min(static_cast<std::size_t>(time / step_s), speed_m_per_s.size() - 2);
    const double since = time - step_s * static_cast<double>(i);
    const double gain = (speed_m_per_s[i + 1] - speed_m_per_s[i]) / step_s;
    return distance_m[i] + since * (speed_m_per_s[i] + 0.5 * gain * since);
}

double TrackPath::time_at(double distance) const {
    if (distance <= 0.0) return distance / speed_m_per_s.front();
    const double last = step_s * static_cast<double>(speed_m_per_s.size() - 1);
    if (distance >= distance_m.back()) return last + (distance - distance_m.back()) / speed_m_per_s.back();
    const auto above = std::upper_bound(distance_m.begin(), distance_m.end(), distance);
    const auto i = static_cast<std::size_t>(above - distance_m.begin()) - 1;
    const double left = distance - distance_m[i], v = speed_m_per_s[i];
    const double gain = (speed_m_per_s[i + 1] - v) / step_s;
    // v·t + ½·gain·t² = left, written without a difference of like numbers.
    return step_s * static_cast<double>(i) + 2.0 * left / (v + std::sqrt(std::max(0.0, v * v + 2.0 * gain * left)));
}

TrackPath track_path(const std::vector<double>& time, const std::vector<double>& speed, double step, double end) {
    assert(!time.empty() && time.size() == speed.size());
    TrackPath path{.step_s = step, .speed_m_per_s = {}, .distance_m = {0.0}};
    const auto count = std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(end / step)) + 1);
    for (std::size_t i = 0; i < count; ++i) {
        const double at = step * static_cast<double>(i);
        const auto after = std::upper_bound(time.begin(), time.end(), at);
        if (after == time.begin()) {
            path.speed_m_per_s.push_back(speed.front());
        } else if (after == time.end()) {
            path.speed_m_per_s.push_back(speed.back());
        } else {
            const auto k = static_cast<std::size_t>(after - time.begin());
            const double share = (at - time[k - 1]) / (time[k] - time[k - 1]);
            path.speed_m_per_s.push_back((1.0 - share) * speed[k - 1] + share * speed[k]);
        }
    }
    for (std::size_t i = 1; i < count; ++i)
        path.distance_m.push_back(path.distance_m.back() +
                                  0.5 * step * (path.speed_m_per_s[i - 1] + path.speed_m_per_s[i]));
    return path;
}

}  // namespace railpem::recordings

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recordings/checks/checks.hpp"
#include "recordings/checks/line_names.hpp"
#include "recordings/stated_speed.hpp"

namespace railpem::recordings::checks {
namespace {

/// Grid frequencies are kept within 0.05 Hz (50, 60 Hz) and 0.01 of that number for the railway's 16 2/3 and 16.7 Hz.
struct Grid {
    double frequency_hz, tolerance_hz;
    int multiples;
};
constexpr Grid grids[] = {{50.0, 0.06, 6}, {60.0, 0.06, 5}, {16.683, 0.05, 1}};

/// Speed of the record, and how far a line that scales with it may be from its mean.
struct LineSpeed {
    double m_per_s = 0.0, error = 0.0;
};

LineSpeed speed_of_lines(const Evidence& evidence) {
    if (evidence.running) {
        const auto& speeds = evidence.running->path.speed_m_per_s;
        const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
        // Names allow two errors to either side: together the range in which the speed was.
        return {evidence.running->path.mean_m_per_s(), 0.25 * (*high - *low)};
    }
    if (evidence.speed) return {evidence.speed->speed_m_per_s, evidence.speed->standard_error_m_per_s};
    const StatedSpeed stated = stated_speed(evidence.recording);
    return {stated.m_per_s, std::max(0.005 * stated.m_per_s, stated.standard_error)};
}

/// A multiple of a grid's frequency, with all channels that have a line there.
struct Hum {
    std::vector<std::string> channels;
    double strongest = 0.0, frequency_hz = 0.0, false_alarm = 1.0;
};

Hum hum_at(const Evidence& evidence, const Grid& grid, int multiple, const LineSpeed& speed) {
    Hum hum;
    for (std::size_t i = 0; i < evidence.lines.size(); ++i)
        for (const SpectralLine& line : evidence.lines[i]) {
            if (std::abs(line.frequency_hz - multiple * grid.frequency_hz) > multiple * grid.tolerance_hz) continue;
            // A line that the wheels or the sleepers make at this speed needs no other name.
            if (!name_of_order(line.frequency_hz, speed.m_per_s, speed.error, evidence.context).empty()) continue;
            if (hum.channels.empty() || hum.channels.back() != evidence.name(i))
                hum.channels.push_back(evidence.name(i));
            hum.false_alarm = std::min(hum.false_alarm, line.false_alarm);
            const double rms = std::sqrt(line.mean_square);
            if (rms <= hum.strongest) continue;
            hum.strongest = rms;
            hum.frequency_hz = line.frequency_hz;
        }
    return hum;
}

}  // namespace

void check_mains(const Evidence& evidence, std::vector<Fault>& faults) {
    const LineSpeed speed = speed_of_lines(evidence);
    for (const Grid& grid : grids)
        for (int multiple = 1; multiple <= grid.multiples; ++multiple) {
            const Hum hum = hum_at(evidence, grid, multiple, speed);
            if (hum.channels.empty()) continue;
            Fault found;
            found.kind = FaultKind::mains_hum;
            found.channels = hum.channels;
            found.says = fmt::format("a line at {:.3f} Hz with {}{:.3g} rms, {} × the mains frequency of {:.4g} Hz",
                                     hum.frequency_hz, hum.channels.size() > 1 ? "up to " : "", hum.strongest, multiple,
                                     grid.frequency_hz);
            found.low_hz = hum.frequency_hz - grid.tolerance_hz;
            found.high_hz = hum.frequency_hz + grid.tolerance_hz;
            found.value = hum.strongest;
            found.unit = "SI";
            found.false_alarm = hum.false_alarm;
            faults.push_back(std::move(found));
        }
}

}  // namespace railpem::recordings::checks

#include <fmt/format.h>

#include <cmath>

#include "recordings/checks/checks.hpp"
#include "recordings/checks/line_names.hpp"

namespace railpem::recordings::checks {
namespace {

/// Grid frequencies are kept within 0.05 Hz (50, 60 Hz) and 0.01 of that number for the railway's 16 2/3 and 16.7 Hz.
struct Grid {
    double frequency_hz, tolerance_hz;
    int multiples;
};
constexpr Grid grids[] = {{50.0, 0.06, 6}, {60.0, 0.06, 5}, {16.683, 0.05, 1}};

}  // namespace

void check_mains(const Evidence& evidence, std::vector<Fault>& faults) {
    for (std::size_t i = 0; i < evidence.lines.size(); ++i)
        for (const SpectralLine& line : evidence.lines[i])
            for (const Grid& grid : grids) {
                const double multiple = std::round(line.frequency_hz / grid.frequency_hz);
                if (multiple < 1.0 || multiple > grid.multiples ||
                    std::abs(line.frequency_hz - multiple * grid.frequency_hz) > multiple * grid.tolerance_hz)
                    continue;
                const double speed =
                    evidence.speed ? evidence.speed->speed_m_per_s : evidence.recording.description.speed_m_per_s;
                const double error =
                    evidence.speed
                        ? evidence.speed->standard_error_m_per_s
                        : std::max(0.005 * speed, evidence.recording.description.speed_standard_error_m_per_s);
                const std::string also = name_of_order(line.frequency_hz, speed, error, evidence.context);
                Fault found;
                found.kind = FaultKind::mains_hum;
                found.severity = also.empty() ? Severity::warning : Severity::note;
                found.channels = {evidence.name(i)};
                found.says =
                    fmt::format("a line at {:.3f} Hz with {:.3g} rms, {:.0f} × the mains frequency of {:.4g} Hz{}",
                                line.frequency_hz, std::sqrt(line.mean_square), multiple, grid.frequency_hz,
                                also.empty() ? "" : fmt::format("; at this speed it may as well be {}", also));
                found.low_hz = line.frequency_hz - grid.tolerance_hz;
                found.high_hz = line.frequency_hz + grid.tolerance_hz;
                found.value = std::sqrt(line.mean_square);
                found.unit = "SI";
                found.false_alarm = line.false_alarm;
                faults.push_back(std::move(found));
            }
}

}  // namespace railpem::recordings::checks

#include "recordings/loading/file_clock.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "parameters/parameter_error.hpp"
#include "recordings/files/known_units.hpp"

namespace railpem::recordings {
namespace {

constexpr double seconds_per_day = 86400.0;
/// A step against a stated rate: loggers round their times, but not by more than this.
constexpr double same_step = 0.05;
/// Faster than any accelerometer of a train is sampled: what is faster as seconds is something else.
constexpr double highest_rate_hz = 1e6;

struct TimeUnit {
    double factor;
    const char* name;
};
constexpr std::array<TimeUnit, 6> other_units = {
    {{1e-3, "ms"}, {1e-6, "us"}, {1e-9, "ns"}, {60.0, "min"}, {3600.0, "h"}, {seconds_per_day, "days"}}};

std::string date_and_time(double seconds_since_1970) {
    const double whole = std::floor(seconds_since_1970);
    return fmt::format("{:%Y-%m-%d %H:%M:%S}.{:03.0f} UTC", fmt::gmtime(static_cast<std::time_t>(whole)),
                       std::min(999.0, std::floor(1e3 * (seconds_since_1970 - whole))));
}

/// The first time that is there; NaN: none is.
double first_of(const std::vector<double>& times) {
    const auto found = std::find_if(times.begin(), times.end(), [](double t) { return std::isfinite(t); });
    return found == times.end() ? std::nan("") : *found;
}

}  // namespace

double median_step(const std::vector<double>& times) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < times.size(); ++i)
        if (times[i] >= times[i - 1]) steps.push_back(times[i] - times[i - 1]);
    if (steps.empty()) return 0.0;
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
    return steps[steps.size() / 2];
}

double rate_of_times(const std::vector<double>& time, bool& stand_still) {
    // The median step, so that a gap does not spoil it; a millionth of a percent is below what a clock can promise.
    std::vector<double> steps;
    std::size_t still = 0;
    for (std::size_t i = 1; i < time.size(); ++i) {
        if (time[i] - time[i - 1] > 0.0) steps.push_back(time[i] - time[i - 1]);
        still += time[i] == time[i - 1] ? 1 : 0;
    }
    stand_still = still > 0 && still >= steps.size();
    if (steps.size() < 2 || stand_still) return 0.0;
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
    const double median = steps[steps.size() / 2];
    // Within steps near the median the mean is finer than the digits of a single time.
    double sum = 0.0;
    std::size_t count = 0;
    for (const double step : steps)
        if (std::abs(step - median) < 0.5 * median) {
            sum += step;
            ++count;
        }
    // Stamps coarser than the interval (1024 Hz in whole ms) repeat every now and then; a single repetition is a fault.
    constexpr double often = 0.005;
    if (static_cast<double>(still) > often * static_cast<double>(steps.size())) count += still;
    return std::round(1e6 * static_cast<double>(count) / sum) / 1e6;
}

bool FileClock::by_said_unit() {
    if (says_.unit.empty()) return false;
    const std::optional<KnownUnit> unit = known_unit(says_.unit);
    if (!unit) return false;  // a word, of which nothing is known
    if (unit->dimension != Dimension::time)
        throw parameters::ParameterError("time_column",
                                         fmt::format("the data file says '{}' ({}) for the times, which is no unit of "
                                                     "time",
                                                     says_.unit, says_.unit_where),
                                         "a column in s, ms, us, min, h or days");
    factor_ = unit->factor;
    return true;
}

bool FileClock::by_rate(double step, std::vector<std::string>& notes) {
    if (rate_hz_ <= 0.0 || step <= 0.0) return false;
    if (std::abs(step * rate_hz_ - 1.0) < same_step) return true;  // seconds
    for (const TimeUnit& unit : other_units)
        if (std::abs(step * unit.factor * rate_hz_ - 1.0) < same_step) {
            factor_ = unit.factor;
            notes.push_back(fmt::format("the times in the file are in {}: with them it says {:g} Hz, as is stated",
                                        unit.name, rate_hz_));
            return true;
        }
    if (step != 1.0) return false;
    factor_ = 1.0 / rate_hz_;
    notes.push_back(fmt::format("the times in the file count the samples; at {:g} Hz they are seconds", rate_hz_));
    return true;
}

/// Seconds, ms, us or ns since 1970, and days of a spreadsheet, by their size. Their origin is left to start().
bool FileClock::by_epoch(const std::vector<double>& times, double step, std::vector<std::string>& notes) {
    const double first = first_of(times);
    constexpr double year_1998 = 8.83e8, year_2100 = 4.1e9;  // s since 1970
    for (const TimeUnit& unit : {TimeUnit{1.0, "s"}, other_units[0], other_units[1], other_units[2]}) {
        const double seconds = first * unit.factor;
        const double rate = step > 0.0 ? 1.0 / (step * unit.factor) : lowest_rate_hz;
        if (!(seconds > year_1998 && seconds < year_2100) || rate < lowest_rate_hz || rate > highest_rate_hz) continue;
        if (factor_ != 1.0 && factor_ != unit.factor) continue;
        factor_ = unit.factor;
        origin_ = first;
        start_ = date_and_time(seconds);
        notes.push_back(fmt::format("the times in the file are {} since 1970, counted from the first", unit.name));
        return true;
    }
    constexpr double spreadsheet_1998 = 35796.0, spreadsheet_2100 = 73051.0, days_to_1970 = 25569.0;
    const bool days = first > spreadsheet_1998 && first < spreadsheet_2100 && step > 0.0 &&
                      (factor_ == seconds_per_day || (factor_ == 1.0 && step * highest_rate_hz < 1.0));
    if (!days) return false;
    factor_ = seconds_per_day;
    origin_ = first;
    start_ = date_and_time((first - days_to_1970) * seconds_per_day);
    notes.emplace_back("the times in the file are days of a spreadsheet, counted from the first");
    return true;
}

void FileClock::find_slow(double step, std::size_t count) {
    if (rate_hz_ > 0.0 || !(step * lowest_rate_hz > 1.0)) return;
    Fault found;
    found.kind = FaultKind::sampling_rate;
    found.severity = Severity::error;
    const auto length = static_cast<double>(count) * step;
    found.says = fmt::format(
        "nobody says the unit of the times: in s they make {:.4g} Hz and {:.4g} s, in ms {:.4g} Hz "
        "and {:.4g} s, and the former is too slow for a vehicle; name the unit in the header "
        "(time [ms]) or state sampling_rate_hz",
        1.0 / step, length, 1e3 / step, 1e-3 * length);
    found.value = 1.0 / step;
    found.unit = "Hz";
    slow_ = std::move(found);
}

void FileClock::begin(const std::vector<double>& times, std::vector<std::string>& notes) {
    begun_ = true;
    if (writing_ != TimeWriting::numbers) return;
    const double step = median_step(times);
    const bool known = by_said_unit() || by_rate(step, notes);
    const bool counted = by_epoch(times, step, notes);
    if (!known && !counted) find_slow(step, times.size());
}

/// Times of day begin again at midnight; so do seconds since midnight. Numbers that run backwards by anything but a
/// day are left as they are.
void FileClock::unwrap(std::vector<double>& times) {
    for (double& time : times) {
        if (!std::isfinite(time)) continue;
        const double back = last_ - time;
        const bool midnight = writing_ == TimeWriting::times_of_day ? back > 0.5 * seconds_per_day
                                                                    : std::abs(back - seconds_per_day) < 1.0;
        if (midnight) days_ += seconds_per_day;
        last_ = time;
        time += days_;
    }
}

std::vector<double> FileClock::seconds(std::vector<double> times, std::vector<std::string>& notes,
                                       std::vector<Fault>& contradictions) {
    if (!begun_) begin(times, notes);
    if (slow_) contradictions.push_back(*slow_);
    if (factor_ != 1.0 || origin_ != 0.0)
        for (double& time : times) time = (time - origin_) * factor_;
    if (writing_ != TimeWriting::dates) unwrap(times);
    return times;
}

}  // namespace railpem::recordings

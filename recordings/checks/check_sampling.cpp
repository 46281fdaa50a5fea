#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recordings/checks/checks.hpp"
#include "recordings/checks/median.hpp"

namespace railpem::recordings::checks {
namespace {

Fault whole_record(FaultKind kind, Severity severity, std::string says, double value, std::string unit) {
    Fault found;
    found.kind = kind;
    found.severity = severity;
    found.says = std::move(says);
    found.value = value;
    found.unit = std::move(unit);
    return found;
}

/// The step in which the times are written: the largest power of ten (times 1 or 5) of which all of them are multiples.
double written_step(const std::vector<double>& time) {
    for (double step = 1.0; step > 1e-12; step /= 10.0) {
        bool fits = true;
        for (std::size_t i = 0; i < time.size() && fits; i += 1 + time.size() / 2000)
            fits = std::abs(time[i] / step - std::round(time[i] / step)) < 1e-4 + 4e-16 * std::abs(time[i]) / step;
        if (fits) return step;
    }
    return 0.0;
}

/// Of times that are written more coarsely than the samples follow each other, so that several share one: how far apart
/// such times are, s. 0: every sample has a time of its own; a logger that now and then writes one twice is not meant.
double coarse_step(const std::vector<double>& time, double rate) {
    std::vector<double> steps;
    std::size_t still = 0;
    for (std::size_t i = 1; i < time.size(); ++i) {
        if (time[i] > time[i - 1]) steps.push_back(time[i] - time[i - 1]);
        still += time[i] == time[i - 1] ? 1 : 0;
    }
    if (still == 0 || steps.empty()) return 0.0;
    const double step = std::max(median(steps), written_step(time));
    return step > 1.01 / rate ? step : 0.0;
}

/// Coarse times show gaps that are longer than they are, and the rate over the whole record.
void check_coarse_times(const std::vector<double>& time, double rate, double step, std::vector<Fault>& faults) {
    faults.push_back(
        whole_record(FaultKind::sampling_jitter, Severity::note,
                     fmt::format("the times in the file are coarser than the sampling interval, about "
                                 "{:.4g} samples share one: the rate was taken as stated, and gaps shorter "
                                 "than {:.4g} s cannot be seen",
                                 std::max(1.0, step * rate), step),
                     step, "s"));
    const auto changes = [&](std::size_t i) { return time[i] > time[i - 1]; };
    std::size_t first = 1, last = time.size() - 1;
    while (first < last && !changes(first)) ++first;
    while (last > first && !changes(last)) --last;
    const double elapsed = time[last] - time[first];
    if (elapsed < 10.0 * step) return;  // too few times to tell a rate
    const auto rows = static_cast<double>(last - first);
    const double found = rows / elapsed;
    // The first and the last change are known to a sample each, and rounding moves them by as much as it rounds.
    if (std::abs(found / rate - 1.0) > std::max(1e-4, 2.0 / rows + (step * rate < 2.0 ? step / elapsed : 0.0)))
        faults.push_back(whole_record(
            FaultKind::sampling_rate, Severity::error,
            fmt::format(
                "the times in the file say {:.6g} Hz, {:g} Hz is stated: every frequency is off by {:.3g} %, or "
                "samples are missing",
                found, rate, 100.0 * (found / rate - 1.0)),
            found, "Hz"));
}

void check_times(const Evidence& evidence, std::vector<Fault>& faults) {
    const auto& time = evidence.series().time_s;
    const double rate = evidence.series().sampling_rate_hz;
    if (time.size() < 3) return;
    const double coarse = coarse_step(time, rate);
    std::vector<double> steps;
    std::size_t gaps = 0, backwards = 0, missing = 0;
    double longest = 0.0, at = 0.0;
    for (std::size_t i = 1; i < time.size(); ++i) {
        if (!std::isfinite(time[i]) || !std::isfinite(time[i - 1])) {
            ++missing;
            continue;
        }
        const double step = time[i] - time[i - 1];
        backwards += step < 0.0 || (step == 0.0 && coarse == 0.0) ? 1 : 0;
        if (step > 1.5 / rate + coarse) {
            ++gaps;
            if (step > longest) {
                longest = step;
                at = time[i - 1];
            }
        } else if (step > 0.0) {
            steps.push_back(step);
        }
    }
    if (gaps > 0) {
        Fault found = whole_record(FaultKind::missing_samples, Severity::error,
                                   fmt::format("the time jumps {} time{}, the longest by {:.4g} s at {:.3f} s: samples "
                                               "are missing there, and what follows is late",
                                               gaps, gaps > 1 ? "s" : "", longest, at),
                                   static_cast<double>(gaps), "1");
        found.from_s = at - time.front();
        found.to_s = at - time.front() + longest;
        faults.push_back(std::move(found));
    }
    if (backwards + missing > 0)
        faults.push_back(whole_record(
            FaultKind::sampling_jitter, Severity::error,
            fmt::format("the time stands still or runs backwards {} times and is missing {} times", backwards, missing),
            static_cast<double>(backwards + missing), "1"));
    if (coarse > 0.0) {
        check_coarse_times(time, rate, coarse, faults);
        return;
    }
    if (steps.size() < 16) return;
    double mean = 0.0, square = 0.0;
    for (const double step : steps) mean += step / static_cast<double>(steps.size());
    for (const double step : steps) square += (step - mean) * (step - mean);
    const double deviation = std::sqrt(square / static_cast<double>(steps.size() - 1));
    // Times written with few digits scatter by their last digit alone: two rounded times differ by at most one step of
    // it.
    const double rounding = 0.5 * written_step(time);
    if (deviation > std::max(2.0 * rounding, 0.002 * mean)) {
        const double error_phase = 100.0 * 2.0 * 3.14159265 * deviation;
        faults.push_back(whole_record(
            FaultKind::sampling_jitter, deviation > 0.05 * mean ? Severity::error : Severity::warning,
            fmt::format("the sampling interval scatters by {:.3g} ms ({:.2g} %): a phase error of {:.2g} rad at 100 Hz",
                        1e3 * deviation, 100.0 * deviation / mean, error_phase),
            deviation, "s"));
    }
    const double found_rate = 1.0 / mean;
    if (gaps == 0 &&
        std::abs(found_rate / rate - 1.0) > std::max(1e-4, 2.0 * rounding / (mean * static_cast<double>(steps.size()))))
        faults.push_back(whole_record(
            FaultKind::sampling_rate, Severity::error,
            fmt::format("the times in the file say {:.6g} Hz, {:g} Hz is stated: every frequency is off by {:.3g} %",
                        found_rate, rate, 100.0 * (found_rate / rate - 1.0)),
            found_rate, "Hz"));
}

void check_mileage(const Evidence& evidence, std::vector<Fault>& faults) {
    const TimeSeries& series = evidence.series();
    if (series.mileage_m.size() < 100) return;
    const double duration = static_cast<double>(series.mileage_m.size() - 1) / series.sampling_rate_hz;
    const double travelled = std::abs(series.mileage_m.back() - series.mileage_m.front());
    // A tachometer's steps scatter with the speed; a mileage computed afterwards grows by the same step, but for its
    // last digit.
    std::vector<double> steps;
    constexpr std::size_t stride = 50;
    for (std::size_t i = stride; i < series.mileage_m.size(); i += stride)
        steps.push_back(std::abs(series.mileage_m[i] - series.mileage_m[i - stride]));
    const double step = median(steps);
    double largest = 0.0;
    for (const double s : steps) largest = std::max(largest, std::abs(s - step));
    const bool constant = step > 0.0 && largest < 0.005 * step;
    if (constant)
        faults.push_back(whole_record(
            FaultKind::mileage, Severity::note,
            fmt::format(
                "the mileage grows by one constant step ({:.4g} m/s): it was computed, not measured by a tachometer",
                travelled / duration),
            travelled / duration, "m/s"));
    double speed = 0.0, spread = 0.0;
    if (series.speed_m_per_s.size() > 1) {
        for (const double v : series.speed_m_per_s) speed += v / static_cast<double>(series.speed_m_per_s.size());
        spread = 0.01;
    } else if (evidence.recording.description.speed_m_per_s > 0.0) {
        speed = evidence.recording.description.speed_m_per_s;
        spread = std::max(0.005, 2.0 * evidence.recording.description.speed_standard_error_m_per_s / speed);
    }
    if (speed <= 0.0) return;
    const double ratio = travelled / duration / speed - 1.0;
    if (std::abs(ratio) > spread)
        faults.push_back(whole_record(
            FaultKind::mileage, Severity::warning,
            fmt::format("the mileage is {:.2g} % {} for the speed: {:.1f} m where {:.4g} m/s make {:.1f} m",
                        100.0 * std::abs(ratio), ratio < 0.0 ? "short" : "long", travelled, speed, speed * duration),
            ratio, "1"));
}

}  // namespace

void check_sampling(const Evidence& evidence, std::vector<Fault>& faults) {
    check_times(evidence, faults);
    check_mileage(evidence, faults);
}

void check_aliasing(const Evidence& evidence, std::vector<Fault>& faults) {
    if (!evidence.spectra) return;
    const CrossSpectra& spectra = *evidence.spectra;
    const double half = 0.5 * spectra.sampling_rate_hz;
    for (std::size_t i = 0; i < spectra.size(); ++i) {
        // Highest median in bands of a third-octave (three bins at least), against the last tenth before half the rate.
        std::vector<double> last;
        double highest = 0.0;
        for (std::size_t k = 1; k < spectra.bins(); ++k)
            if (spectra.frequency_hz[k] > 0.88 * half && spectra.frequency_hz[k] < 0.98 * half)
                last.push_back(spectra.psd(k, i));
        for (double low = 0.5; low < 0.88 * half; low *= 1.26) {
            std::vector<double> band;
            const double high = std::max(1.26 * low, low + 3.1 * spectra.kernel().bin_hz());
            for (std::size_t k = 1; k < spectra.bins(); ++k)
                if (spectra.frequency_hz[k] >= low && spectra.frequency_hz[k] < high) band.push_back(spectra.psd(k, i));
            highest = std::max(highest, median(band));
        }
        if (last.size() < 4 || highest <= 0.0) continue;
        const double fall_db = 10.0 * std::log10(highest / std::max(1e-300, median(last)));
        // 20 dB: what folds back is then at least 20 dB below the strongest band. A filter would leave 40 dB and more.
        if (fall_db > 20.0) continue;
        Fault found;
        found.kind = FaultKind::aliasing;
        found.severity = fall_db < 10.0 ? Severity::error : Severity::warning;
        found.channels = {evidence.name(i)};
        found.says = fmt::format(
            "the spectrum has fallen by only {:.0f} dB at half the sampling rate: without an anti-aliasing filter "
            "vibration above {:g} Hz is folded into the record",
            fall_db, half);
        found.low_hz = 0.0;
        found.high_hz = half;
        found.value = fall_db;
        found.unit = "dB";
        found.false_alarm = 0.0;
        faults.push_back(std::move(found));
    }
}

}  // namespace railpem::recordings::checks

#include "recordings/inspection/inspected_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "parameters/parameter_error.hpp"
#include "recordings/checks/checks.hpp"
#include "recordings/estimates/decimate.hpp"
#include "recordings/files/visible_text.hpp"
#include "recordings/inspection/inspection_steps.hpp"
#include "recordings/inspection/spectrogram.hpp"
#include "recordings/stated_speed.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {
namespace {

constexpr double window_s = 2.0;

std::vector<double> detrended_without_gaps(const std::vector<double>& samples) {
    std::vector<double> result = without_trend(samples);
    for (double& value : result)
        if (!std::isfinite(value)) value = 0.0;
    return result;
}

std::optional<CrossSpectra> spectra_of(const TimeSeries& series) {
    try {
        return estimate_cross_spectra(series, {.window_s = window_s});
    } catch (const parameters::ParameterError&) {  // shorter than a window, or never complete: said by the checks
        return std::nullopt;
    }
}

/// A record that is sampled much faster than lines and delays need is thinned for them.
void thin(checks::Evidence& evidence) {
    const double rate = evidence.series().sampling_rate_hz;
    const std::size_t factor = decimation_factor(rate, checks::highest_line_hz);
    if (factor < 2) return;
    evidence.thinned_rate_hz = rate / static_cast<double>(factor);
    for (const std::vector<double>& samples : evidence.detrended)
        evidence.thinned.push_back(decimated(samples, rate, factor, checks::highest_line_hz));
}

TimeSeries thinned_series(const checks::Evidence& evidence) {
    TimeSeries series;
    series.sampling_rate_hz = evidence.thinned_rate_hz;
    for (std::size_t i = 0; i < evidence.thinned.size(); ++i)
        series.channels.push_back({evidence.series().channels[i].description, evidence.thinned[i], {}});
    return series;
}

checks::Evidence gather(const Recording& recording, const InspectionContext& context,
                        const std::optional<CrossSpectra>& spectra) {
    checks::Evidence evidence{recording, context, spectra ? &*spectra : nullptr, {}, {}, {}, {}, {}, 0.0};
    for (const Channel& channel : recording.series.channels)
        evidence.detrended.push_back(detrended_without_gaps(channel.samples));
    thin(evidence);
    const bool thinned = !evidence.thinned.empty();
    for (std::size_t i = 0; i < evidence.detrended.size(); ++i)
        evidence.lines.push_back(find_lines(evidence.slow(i), evidence.slow_rate_hz(),
                                            thinned ? LineOptions{.to_hz = checks::highest_line_hz} : LineOptions{}));
    if (context.geometry) {
        evidence.delays = thinned ? wheelbase_delays(thinned_series(evidence), *context.geometry, {})
                                  : wheelbase_delays(recording.series, *context.geometry, {});
        evidence.speed = wheelbase_speed(evidence.delays);
    }
    return evidence;
}

void add_channel(const checks::Evidence& evidence, std::size_t i, InspectionReport& report) {
    const Channel& channel = evidence.series().channels[i];
    ChannelInspection inspection;
    inspection.description = channel.description;
    inspection.unit_says = channel.unit_says;
    double count = 0.0, second = 0.0, fourth = 0.0;
    for (const double x : channel.samples)
        if (std::isfinite(x)) {
            inspection.mean += x;
            count += 1.0;
        }
    inspection.mean /= std::max(1.0, count);
    for (const double x : evidence.detrended[i]) {
        second += x * x;
        fourth += x * x * x * x;
        inspection.peak = std::max(inspection.peak, std::abs(x));
    }
    inspection.rms = std::sqrt(second / std::max(1.0, count));
    inspection.kurtosis = second > 0.0 ? fourth * count / (second * second) : 0.0;
    inspection.noise_rms = std::numeric_limits<double>::quiet_NaN();
    inspection.lines = evidence.lines[i];
    report.channels.push_back(std::move(inspection));
}

/// Axle boxes or bogies of which no delay to another was found, though the recording has several: nothing was seen of
/// their timing, order and polarity.
std::vector<std::string> without_delay(const checks::Evidence& evidence, Location location) {
    std::vector<std::string> alone;
    std::size_t members = 0;
    for (std::size_t i = 0; i < evidence.series().channels.size(); ++i) {
        if (evidence.series().channels[i].description.location != location) continue;
        ++members;
        if (std::none_of(evidence.delays.begin(), evidence.delays.end(),
                         [&](const PairDelay& pair) { return pair.front == i || pair.rear == i; }))
            alone.push_back(evidence.name(i));
    }
    return members > 1 ? alone : std::vector<std::string>{};
}

/// What was not looked at, so that silence is not taken for soundness.
void add_not_checked(const checks::Evidence& evidence, InspectionReport& report) {
    const TimeSeries& series = evidence.series();
    if (!evidence.thinned.empty())
        report.not_checked.push_back(fmt::format("lines above {:g} Hz", checks::highest_line_hz));
    if (series.time_s.empty())
        report.not_checked.emplace_back("sampling jitter and gaps in time: the file has no time column");
    if (evidence.context.predicted.empty())
        report.not_checked.emplace_back("units against a prediction: no case was given");
    if (!evidence.context.geometry)
        report.not_checked.emplace_back(
            "speed, timing, order and polarity of the axle boxes by their delays: no case was given, the wheelbase is "
            "not known");
    else if (evidence.delays.empty())
        report.not_checked.emplace_back(
            "speed, timing, order and polarity by delays: no two axle boxes or bogies show the same track");
    else
        for (const Location location : {Location::wheel, Location::bogie})
            if (const std::vector<std::string> alone = without_delay(evidence, location); !alone.empty())
                report.not_checked.push_back(
                    fmt::format("timing, order and polarity of {} by delays: none to another such channel was found; a "
                                "longer record shows more",
                                fmt::join(alone, ", ")));
    if (!evidence.spectra)
        report.not_checked.emplace_back("everything that needs a spectrum: there is no complete window of 2 s");
    std::vector<std::string> body;
    for (const Channel& channel : series.channels)
        if (channel.description.location == Location::body) body.push_back(channel.description.name);
    if (!body.empty() && body.size() < 3)
        report.not_checked.push_back(
            fmt::format("polarity and timing of {}: a rigid body tells them from its two ends and its centre together; "
                        "fewer channels look alike either way up, only a model with the wheels or bogies can decide",
                        fmt::join(body, ", ")));
}

void run_checks(const checks::Evidence& evidence, std::vector<Fault>& faults) {
    for (const auto check :
         {checks::check_samples, checks::check_soft_clipping, checks::check_offset, checks::check_unit,
          checks::check_channels, checks::check_polarity, checks::check_timing, checks::check_mains,
          checks::check_aliasing, checks::check_sampling, checks::check_stationarity, checks::check_impacts})
        check(evidence, faults);
}

/// Of a profile its figures are kept and its spectrum, not its samples.
void take_irregularity(const MeasuredIrregularity& brought, InspectionReport& report) {
    report.irregularity = brought;
    report.irregularity.position_m.clear();
    report.irregularity.height_m.clear();
    if (!brought.is_profile()) return;
    const auto count = static_cast<double>(brought.height_m.size());
    double mean = 0.0, square = 0.0;
    for (const double height : brought.height_m) mean += height / count;
    for (const double height : brought.height_m) square += (height - mean) * (height - mean) / count;
    report.profile_length_m = brought.position_m.back() - brought.position_m.front();
    report.profile_step_m = report.profile_length_m / (count - 1.0);
    report.profile_rms_m = std::sqrt(square);
}

InspectionReport header(const Recording& recording) {
    InspectionReport report;
    report.title = visible(recording.description.title);
    report.file = visible(recording.file);
    report.start = recording.start;
    report.kind = recording.description.kind;
    report.faults = recording.contradictions;
    const StatedSpeed speed = stated_speed(recording);
    report.stated_speed_m_per_s = speed.m_per_s;
    report.stated_speed_error_m_per_s = speed.standard_error;
    report.lacks = recording.lacks;
    report.notes = recording.notes;
    report.spectra = recording.spectra;
    report.receptance = recording.receptance;
    report.decay_rate = recording.decay_rate;
    take_irregularity(recording.irregularity, report);
    return report;
}

}  // namespace

InspectedSection inspect_section(const Recording& recording, const InspectionContext& context) {
    InspectedSection section{header(recording), std::nullopt};
    InspectionReport& report = section.report;
    if (report.kind != RecordingKind::timeseries) {
        report.not_checked.emplace_back("sensors: this kind of data holds no time series");
        return section;
    }
    const TimeSeries& series = recording.series;
    report.duration_s = series.duration_s();
    report.sampling_rate_hz = series.sampling_rate_hz;
    report.samples = series.size();
    section.spectra = spectra_of(series);
    const checks::Evidence evidence = gather(recording, context, section.spectra);
    if (evidence.speed) {
        report.speed_m_per_s = evidence.speed->speed_m_per_s;
        report.speed_error_m_per_s = evidence.speed->standard_error_m_per_s;
        report.speed_pairs = evidence.speed->pairs_used;
    }
    for (std::size_t i = 0; i < series.channels.size(); ++i) add_channel(evidence, i, report);
    run_checks(evidence, report.faults);
    sort_faults(report.faults);
    report.spectrograms = spectrograms_of(series);
    add_not_checked(evidence, report);
    return section;
}

}  // namespace railpem::recordings

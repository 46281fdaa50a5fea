#include "recordings/inspection/inspected_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "parameters/parameter_error.hpp"
#include "recordings/checks/check_tables.hpp"
#include "recordings/checks/checks.hpp"
#include "recordings/checks/consequences.hpp"
#include "recordings/checks/true_places.hpp"
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

/// From the delays where they say it, else from a speed channel, else as stated.
SpeedAlong speed_along(const checks::Evidence& evidence, const StatedSpeed& stated) {
    const auto between = [&](const std::vector<double>& speeds, double mean, const char* from) {
        SpeedAlong along{mean, 1e300, 0.0, from};
        for (const double v : speeds)
            if (std::isfinite(v)) {
                along.lowest_m_per_s = std::min(along.lowest_m_per_s, v);
                along.highest_m_per_s = std::max(along.highest_m_per_s, v);
            }
        if (!evidence.stops.empty()) along.lowest_m_per_s = 0.0;
        return along;
    };
    if (evidence.running)
        return between(evidence.running->path.speed_m_per_s, evidence.running->path.mean_m_per_s(), "delays");
    if (evidence.recording.description.speed_m_per_s > 0.0)
        return between({stated.m_per_s}, stated.m_per_s, "description");
    if (stated.m_per_s > 0.0) return between(evidence.series().speed_m_per_s, stated.m_per_s, "speed channel");
    return {};
}

/// A recording and its spectra with channels at their true places: copies only where some were exchanged.
class AtTruePlaces {
  public:
    AtTruePlaces(const Recording& recording, const std::optional<CrossSpectra>& spectra,
                 const checks::TruePlaces& places)
        : recording_(recording), spectra_(spectra) {
        if (places.exchanges.empty()) return;
        placed_ = recording;
        for (std::size_t i = 0; i < places.channels.size(); ++i)
            placed_->series.channels[i].description = places.channels[i];
        placed_spectra_ = spectra;
        if (placed_spectra_) placed_spectra_->channels = places.channels;
    }
    const Recording& recording() const { return placed_ ? *placed_ : recording_; }
    const CrossSpectra* spectra() const {
        const std::optional<CrossSpectra>& seen = placed_ ? placed_spectra_ : spectra_;
        return seen ? &*seen : nullptr;
    }

  private:
    const Recording& recording_;
    const std::optional<CrossSpectra>& spectra_;
    std::optional<Recording> placed_;
    std::optional<CrossSpectra> placed_spectra_;
};

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
    // What explains others comes before them: a channel of few digits is not clipped, one without signal above some
    // frequency has its unit, a clock that drifts is no skew.
    for (const auto check :
         {checks::check_stops, checks::check_samples, checks::check_soft_clipping, checks::check_offset,
          checks::check_band_limit, checks::check_unit, checks::check_channels, checks::check_polarity,
          checks::check_clock, checks::check_timing, checks::check_mains, checks::check_aliasing,
          checks::check_sampling, checks::check_speed, checks::check_stationarity, checks::check_impacts})
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
        for (Fault& fault : checks::check_tables(recording, context)) report.faults.push_back(std::move(fault));
        sort_faults(report.faults);
        report.not_checked.emplace_back("sensors: this kind of data holds no time series");
        const bool is_table = recording.description.kind == RecordingKind::receptance ||
                              recording.description.kind == RecordingKind::decay_rate;
        if (is_table ? context.track.frequency_hz.empty() : context.predicted.empty())
            report.not_checked.emplace_back("sizes against a prediction: no case was given");
        return section;
    }
    const TimeSeries& series = recording.series;
    report.duration_s = series.duration_s();
    report.sampling_rate_hz = series.sampling_rate_hz;
    report.samples = series.size();
    section.spectra = spectra_of(series);
    std::vector<std::vector<double>> detrended;
    for (const Channel& channel : series.channels) detrended.push_back(detrended_without_gaps(channel.samples));
    const checks::TruePlaces places =
        checks::true_places(series, context, detrended, section.spectra ? &*section.spectra : nullptr);
    const AtTruePlaces seen(recording, section.spectra, places);
    const checks::Evidence evidence =
        checks::gather_evidence(seen.recording(), context, seen.spectra(), std::move(detrended), places);
    report.faults.insert(report.faults.end(), places.exchanges.begin(), places.exchanges.end());
    report.speed_along = speed_along(evidence, stated_speed(recording));
    if (evidence.speed) {
        report.speed_m_per_s = evidence.speed->speed_m_per_s;
        report.speed_error_m_per_s = evidence.speed->standard_error_m_per_s;
        report.speed_pairs = evidence.speed->pairs_used;
    }
    for (std::size_t i = 0; i < series.channels.size(); ++i) {
        add_channel(evidence, i, report);
        report.channels.back().description = series.channels[i].description;
    }
    run_checks(evidence, report.faults);
    checks::drop_consequences(report.faults);
    sort_faults(report.faults);
    report.spectrograms = spectrograms_of(series);
    add_not_checked(evidence, report);
    return section;
}

}  // namespace railpem::recordings

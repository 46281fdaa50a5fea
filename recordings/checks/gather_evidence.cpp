#include <algorithm>
#include <cmath>

#include "recordings/checks/evidence.hpp"
#include "recordings/checks/stops.hpp"
#include "recordings/estimates/decimate.hpp"
#include "recordings/estimates/laid_delays.hpp"

namespace railpem::recordings::checks {
namespace {

/// The longest stretch between stops.
Stretch moving_stretch(const std::vector<Stretch>& stops, double duration) {
    Stretch longest{0.0, stops.empty() ? duration : stops.front().from_s};
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const Stretch after{stops[i].to_s, i + 1 < stops.size() ? stops[i + 1].from_s : duration};
        if (after.to_s - after.from_s > longest.to_s - longest.from_s) longest = after;
    }
    return longest;
}

TimeSeries cut(const TimeSeries& series, const Stretch& stretch) {
    TimeSeries part{.sampling_rate_hz = series.sampling_rate_hz};
    for (const Channel& channel : series.channels) {
        const auto at = [&](double time) {
            const auto sample = static_cast<std::size_t>(std::lround(time * series.sampling_rate_hz));
            return channel.samples.begin() + static_cast<std::ptrdiff_t>(std::min(sample, channel.samples.size()));
        };
        part.channels.push_back({channel.description, {at(stretch.from_s), at(stretch.to_s)}});
    }
    return part;
}

/// The speed along the record, where the channels agree on one.
std::optional<RunningSpeed> running_along(const TimeSeries& series, const VehicleGeometry& geometry, double expected) {
    constexpr double kLeastAgreement = 0.3;  // as the diagnosis asks for: unrelated channels agree to 0.1
    constexpr int kRefinements = 4;          // the last ones move the speed by less than the delays are known to
    std::optional<RunningSpeed> running = running_speed(series, geometry, expected, {.refinements = kRefinements});
    if (running && running->agreement < kLeastAgreement) running.reset();
    return running;
}

/// A record that is sampled much faster than lines and delays need is thinned for them.
void thin(Evidence& evidence) {
    const double rate = evidence.series().sampling_rate_hz;
    const std::size_t factor = decimation_factor(rate, highest_line_hz);
    if (factor < 2) return;
    evidence.thinned_rate_hz = rate / static_cast<double>(factor);
    for (const std::vector<double>& samples : evidence.detrended)
        evidence.thinned.push_back(decimated(samples, rate, factor, highest_line_hz));
}

TimeSeries thinned_series(const Evidence& evidence) {
    TimeSeries series;
    series.sampling_rate_hz = evidence.thinned_rate_hz;
    for (std::size_t i = 0; i < evidence.thinned.size(); ++i)
        series.channels.push_back({evidence.series().channels[i].description, evidence.thinned[i], {}});
    return series;
}

}  // namespace

Evidence gather_evidence(const Recording& recording, const InspectionContext& context, const CrossSpectra* spectra,
                         std::vector<std::vector<double>> detrended, const TruePlaces& places) {
    Evidence evidence{
        .recording = recording, .context = context, .spectra = spectra, .detrended = std::move(detrended)};
    thin(evidence);
    const bool thinned = !evidence.thinned.empty();
    for (std::size_t i = 0; i < evidence.detrended.size(); ++i)
        evidence.lines.push_back(find_lines(evidence.slow(i), evidence.slow_rate_hz(),
                                            thinned ? LineOptions{.to_hz = highest_line_hz} : LineOptions{}));
    evidence.stops = stops_of(recording.series, evidence.detrended);
    evidence.moving = moving_stretch(evidence.stops, recording.series.duration_s());
    const TimeSeries slow = thinned ? thinned_series(evidence) : TimeSeries{};
    const TimeSeries& series = thinned ? slow : recording.series;
    if (!context.geometry) return evidence;
    const TimeSeries part = evidence.stops.empty() ? TimeSeries{} : cut(series, evidence.moving);
    const TimeSeries& moving = evidence.stops.empty() ? series : part;
    if (places.speed_m_per_s) evidence.running = running_along(moving, *context.geometry, *places.speed_m_per_s);
    evidence.delays = evidence.running ? laid_delays(moving, *context.geometry, evidence.running->path)
                                       : wheelbase_delays(moving, *context.geometry, {});
    evidence.speed = wheelbase_speed(evidence.delays);
    return evidence;
}

}  // namespace railpem::recordings::checks

#include "recordings/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "parameters/parameter_error.hpp"
#include "recordings/checks/checks.hpp"
#include "recordings/confidence.hpp"
#include "recordings/line_names.hpp"
#include "recordings/load_recording.hpp"
#include "recordings/named_frequencies.hpp"
#include "recordings/noise_floor.hpp"
#include "recordings/spectrogram.hpp"
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

checks::Evidence gather(const Recording& recording, const InspectionContext& context,
                        const std::optional<CrossSpectra>& spectra) {
    checks::Evidence evidence{recording, context, spectra ? &*spectra : nullptr, {}, {}, {}, {}};
    for (const Channel& channel : recording.series.channels) {
        evidence.detrended.push_back(detrended_without_gaps(channel.samples));
        evidence.lines.push_back(find_lines(evidence.detrended.back(), recording.series.sampling_rate_hz));
    }
    if (context.geometry) {
        evidence.delays = wheelbase_delays(recording.series, *context.geometry, {});
        evidence.speed = wheelbase_speed(evidence.delays);
    }
    return evidence;
}

double speed_for_names(const InspectionReport& report) {
    return report.speed_m_per_s > 0.0 ? report.speed_m_per_s : report.stated_speed_m_per_s;
}

void add_channel(const checks::Evidence& evidence, std::size_t i, InspectionReport& report) {
    const Channel& channel = evidence.series().channels[i];
    ChannelInspection inspection;
    inspection.description = channel.description;
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
    if (evidence.spectra) {
        const CrossSpectra& spectra = *evidence.spectra;
        for (std::size_t k = 0; k < spectra.bins(); ++k) inspection.psd.push_back(spectra.psd(k, i));
        inspection.bands = band_levels(spectra, i);
        if (spectra.size() > 1 && spectra.averages >= 2.0 * static_cast<double>(spectra.size())) {
            inspection.incoherent = incoherent_part(spectra, i);
            double power = 0.0;
            for (std::size_t k = 0; k < spectra.bins(); ++k)
                if (spectra.frequency_hz[k] > 4.0 && spectra.frequency_hz[k] < 0.4 * spectra.sampling_rate_hz &&
                    std::isfinite(inspection.incoherent[k]))
                    power += inspection.incoherent[k] * spectra.kernel().bin_hz();
            if (power > 0.0) inspection.noise_rms = std::sqrt(power);
        }
    }
    inspection.lines = evidence.lines[i];
    const double speed = speed_for_names(report);
    const double speed_error = report.speed_m_per_s > 0.0 ? report.speed_error_m_per_s
                                                          : std::max(0.01 * speed, report.stated_speed_error_m_per_s);
    for (const SpectralLine& line : inspection.lines) {
        std::string name = name_of_line(line.frequency_hz, speed, speed_error, evidence.context);
        if (name.empty() && report.wheel_orders) name = name_by_rotation(line.frequency_hz, *report.wheel_orders);
        inspection.line_names.push_back(std::move(name));
    }
    report.channels.push_back(std::move(inspection));
}

void add_spectra(const checks::Evidence& evidence, InspectionReport& report) {
    if (!evidence.spectra) return;
    const CrossSpectra& spectra = *evidence.spectra;
    report.frequency_hz = spectra.frequency_hz;
    report.averages = spectra.averages;
    report.coherence_limit = coherence_limit(spectra.averages, 0.05);
    const Interval interval = spectrum_interval(spectra.averages);
    report.interval_low_db = 10.0 * std::log10(interval.low);
    report.interval_high_db = 10.0 * std::log10(interval.high);
    for (std::size_t i = 0; i < spectra.size(); ++i)
        for (std::size_t j = i + 1; j < spectra.size(); ++j) {
            PairCoherence pair{spectra.channels[i].name, spectra.channels[j].name, {}};
            for (std::size_t k = 0; k < spectra.bins(); ++k) pair.coherence.push_back(spectra.coherence(k, i, j));
            report.coherences.push_back(std::move(pair));
        }
}

/// What was not looked at, so that silence is not taken for soundness.
void add_not_checked(const checks::Evidence& evidence, InspectionReport& report) {
    const TimeSeries& series = evidence.series();
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
    if (!evidence.spectra)
        report.not_checked.emplace_back("everything that needs a spectrum: there is no complete window of 2 s");
    bool body_alone = false;
    for (const Channel& channel : series.channels)
        body_alone = body_alone || channel.description.location == Location::body;
    if (body_alone && series.channels.size() < 3)
        report.not_checked.emplace_back("polarity and timing of the body channels: they need both ends and the centre");
}

void sort_faults(std::vector<Fault>& faults) {
    std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
        return static_cast<int>(a.severity) > static_cast<int>(b.severity);
    });
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
    report.title = recording.description.title;
    report.file = recording.file;
    report.kind = recording.description.kind;
    report.stated_speed_m_per_s = recording.description.speed_m_per_s;
    report.stated_speed_error_m_per_s = recording.description.speed_standard_error_m_per_s;
    report.lacks = recording.lacks;
    report.notes = recording.notes;
    report.spectra = recording.spectra;
    report.receptance = recording.receptance;
    report.decay_rate = recording.decay_rate;
    take_irregularity(recording.irregularity, report);
    return report;
}

/// A speed channel stands in for a stated speed: its mean, and how well its values allow to know it.
void take_speed_channel(const TimeSeries& series, InspectionReport& report) {
    if (report.stated_speed_m_per_s > 0.0) return;
    double sum = 0.0, square = 0.0, count = 0.0;
    for (const double v : series.speed_m_per_s)
        if (std::isfinite(v)) {
            sum += v;
            square += v * v;
            count += 1.0;
        }
    if (count == 0.0 || sum <= 0.0) return;
    report.stated_speed_m_per_s = sum / count;
    report.stated_speed_error_m_per_s = std::max(std::sqrt(std::max(0.0, square / count - sum / count * sum / count)),
                                                 0.005 * report.stated_speed_m_per_s);
}

}  // namespace

InspectionReport inspect(const Recording& recording, const InspectionContext& context) {
    InspectionReport report = header(recording);
    if (report.kind != RecordingKind::timeseries) {
        report.not_checked.emplace_back("sensors: this kind of data holds no time series");
        return report;
    }
    const TimeSeries& series = recording.series;
    report.duration_s = series.duration_s();
    report.sampling_rate_hz = series.sampling_rate_hz;
    report.samples = series.size();
    take_speed_channel(series, report);
    const std::optional<CrossSpectra> spectra = spectra_of(series);
    const checks::Evidence evidence = gather(recording, context, spectra);
    if (evidence.speed) {
        report.speed_m_per_s = evidence.speed->speed_m_per_s;
        report.speed_error_m_per_s = evidence.speed->standard_error_m_per_s;
        report.speed_pairs = evidence.speed->pairs_used;
    }
    report.wheel_orders = wheel_orders_of(evidence.lines, speed_for_names(report));
    for (std::size_t i = 0; i < series.channels.size(); ++i) add_channel(evidence, i, report);
    add_spectra(evidence, report);
    checks::check_samples(evidence, report.faults);
    checks::check_offset(evidence, report.faults);
    checks::check_unit(evidence, report.faults);
    checks::check_channels(evidence, report.faults);
    checks::check_polarity(evidence, report.faults);
    checks::check_timing(evidence, report.faults);
    checks::check_mains(evidence, report.faults);
    checks::check_aliasing(evidence, report.faults);
    checks::check_sampling(evidence, report.faults);
    checks::check_stationarity(evidence, report.faults);
    checks::check_impacts(evidence, report.faults);
    sort_faults(report.faults);
    InspectionContext known = context;
    if (known.wheel_radius_m <= 0.0 && report.wheel_orders)
        known.wheel_radius_m = speed_for_names(report) / (2.0 * std::numbers::pi * report.wheel_orders->rotation_hz);
    report.named_frequencies = named_frequencies(speed_for_names(report), 0.5 * report.sampling_rate_hz, known);
    report.spectrograms = spectrograms_of(series);
    add_not_checked(evidence, report);
    return report;
}

InspectionReport inspect_file(const RecordingDescription& description, const std::filesystem::path& base,
                              const InspectionContext& context, std::size_t samples) {
    std::vector<InspectionReport> parts;
    load_in_sections(description, base, samples, [&](const Recording& section) {
        InspectionReport part = inspect(section, context);
        const double start = section.series.start_s;
        for (Fault& fault : part.faults) {
            const bool everywhere = fault.from_s == 0.0 && fault.to_s == 0.0;
            fault.from_s += start;
            fault.to_s += everywhere && start > 0.0 ? start + part.duration_s : start;
        }
        // Of the later sections only what is joined is kept: memory stays bounded.
        if (!parts.empty()) {
            part.coherences.clear();
            part.spectrograms.clear();
        }
        parts.push_back(std::move(part));
    });
    InspectionReport report = std::move(parts.front());
    double weight = report.duration_s;
    for (std::size_t p = 1; p < parts.size(); ++p) {
        InspectionReport& part = parts[p];
        const double share = part.duration_s / (weight + part.duration_s);
        weight += part.duration_s;
        report.samples += part.samples;
        report.duration_s += part.duration_s;
        report.averages += part.averages;
        for (Fault& fault : part.faults)
            if (fault.kind != FaultKind::too_short && fault.kind != FaultKind::unknown_scale)
                report.faults.push_back(std::move(fault));
        for (std::size_t i = 0; i < report.channels.size(); ++i) {
            ChannelInspection &all = report.channels[i], &one = part.channels[i];
            all.rms = std::sqrt((1.0 - share) * all.rms * all.rms + share * one.rms * one.rms);
            all.mean = (1.0 - share) * all.mean + share * one.mean;
            all.peak = std::max(all.peak, one.peak);
            for (std::size_t k = 0; k < all.psd.size() && k < one.psd.size(); ++k)
                all.psd[k] = (1.0 - share) * all.psd[k] + share * one.psd[k];
        }
    }
    if (parts.size() > 1) {
        report.notes.push_back(fmt::format(
            "inspected in {} sections of {:.0f} s: bands, lines, coherence and spectrogram are of the first",
            parts.size(), static_cast<double>(samples) / report.sampling_rate_hz));
        sort_faults(report.faults);
    }
    return report;
}

std::string verdict_of(const InspectionReport& report) {
    if (report.kind != RecordingKind::timeseries)
        return "Read. Faults of the sensors cannot be looked for in this kind of data.";
    const auto count = [&](Severity severity) {
        return std::count_if(report.faults.begin(), report.faults.end(),
                             [&](const Fault& fault) { return fault.severity == severity; });
    };
    const auto errors = count(Severity::error), warnings = count(Severity::warning);
    if (errors > 0)
        return fmt::format("Not to be trusted as it is: {} error{}, {} warning{}.", errors, errors > 1 ? "s" : "",
                           warnings, warnings == 1 ? "" : "s");
    if (warnings > 0) return fmt::format("Usable with care: {} warning{}.", warnings, warnings > 1 ? "s" : "");
    return "No fault was found.";
}

}  // namespace railpem::recordings

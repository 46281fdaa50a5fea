#include "recordings/inspection/inspect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recordings/inspection/inspected_section.hpp"
#include "recordings/inspection/inspection_steps.hpp"
#include "recordings/loading/load_recording.hpp"

namespace railpem::recordings {
namespace {

// A long recording is inspected section by section in bounded memory, and the reports are joined into one.

/// Means weighted with the time behind each.
double weighted(double all, double one, double share) {
    return (1.0 - share) * all + share * one;
}

/// The same line in two sections: closer than the Rayleigh resolution of the 8 s that lines are looked for in, or than
/// their errors say.
bool same_line(const SpectralLine& a, const SpectralLine& b) {
    constexpr double resolution_hz = 1.0 / 8.0;
    return std::abs(a.frequency_hz - b.frequency_hz) <
           std::max(resolution_hz, 3.0 * std::hypot(a.frequency_error_hz, b.frequency_error_hz));
}

/// Lines of both; the power of one that a section does not show counts as nothing there.
void join_lines(const std::vector<SpectralLine>& one, double share, std::vector<SpectralLine>& all) {
    for (SpectralLine& line : all) line.mean_square *= 1.0 - share;
    for (SpectralLine line : one) {
        line.mean_square *= share;
        const auto known =
            std::find_if(all.begin(), all.end(), [&](const SpectralLine& other) { return same_line(line, other); });
        if (known == all.end()) {
            all.push_back(line);
            continue;
        }
        const double a = 1.0 / std::max(1e-18, known->frequency_error_hz * known->frequency_error_hz),
                     b = 1.0 / std::max(1e-18, line.frequency_error_hz * line.frequency_error_hz);
        known->frequency_hz = (a * known->frequency_hz + b * line.frequency_hz) / (a + b);
        known->frequency_error_hz = 1.0 / std::sqrt(a + b);
        known->mean_square += line.mean_square;
        known->background = weighted(known->background, line.background, share);
        known->false_alarm = std::min(known->false_alarm, line.false_alarm);
    }
    std::sort(all.begin(), all.end(),
              [](const SpectralLine& a, const SpectralLine& b) { return a.frequency_hz < b.frequency_hz; });
}

void join_channel(const ChannelInspection& one, double share, ChannelInspection& all) {
    const double square = weighted(all.rms * all.rms, one.rms * one.rms, share);
    const double fourth = weighted(all.kurtosis * std::pow(all.rms, 4), one.kurtosis * std::pow(one.rms, 4), share);
    all.kurtosis = square > 0.0 ? fourth / (square * square) : 0.0;
    all.rms = std::sqrt(square);
    all.mean = weighted(all.mean, one.mean, share);
    all.peak = std::max(all.peak, one.peak);
    join_lines(one.lines, share, all.lines);
}

/// Speeds of the sections: by the delays with their errors, as stated (a speed channel) with their times.
void join_speed(const InspectionReport& one, double share, InspectionReport& all) {
    if (one.stated_speed_m_per_s > 0.0) {
        const double apart = one.stated_speed_m_per_s - all.stated_speed_m_per_s;
        all.stated_speed_error_m_per_s = std::sqrt(
            weighted(std::pow(all.stated_speed_error_m_per_s, 2), std::pow(one.stated_speed_error_m_per_s, 2), share) +
            share * (1.0 - share) * apart * apart);
        all.stated_speed_m_per_s = weighted(all.stated_speed_m_per_s, one.stated_speed_m_per_s, share);
    }
    if (!all.speed_along.read_from.empty() && one.speed_along.read_from == all.speed_along.read_from) {
        all.speed_along.mean_m_per_s = weighted(all.speed_along.mean_m_per_s, one.speed_along.mean_m_per_s, share);
        all.speed_along.lowest_m_per_s = std::min(all.speed_along.lowest_m_per_s, one.speed_along.lowest_m_per_s);
        all.speed_along.highest_m_per_s = std::max(all.speed_along.highest_m_per_s, one.speed_along.highest_m_per_s);
    }
    if (one.speed_m_per_s <= 0.0) return;
    const auto weight = [](const InspectionReport& report) {
        return report.speed_m_per_s > 0.0 ? 1.0 / std::max(1e-18, std::pow(report.speed_error_m_per_s, 2)) : 0.0;
    };
    const double a = weight(all), b = weight(one);
    all.speed_m_per_s = (a * all.speed_m_per_s + b * one.speed_m_per_s) / (a + b);
    all.speed_error_m_per_s = 1.0 / std::sqrt(a + b);
    all.speed_pairs = std::max(all.speed_pairs, one.speed_pairs);
}

/// One fault that several sections show alike, told once, and in how many of them it was seen.
struct SeenFault {
    Fault fault;
    bool everywhere = false;  ///< not bound to a time within its section
    int sections = 1;
};

void add_faults(const InspectionReport& section, double start_s, std::vector<SeenFault>& seen) {
    for (const Fault& fault : section.faults) {
        if (start_s > 0.0 && fault.kind == FaultKind::too_short) continue;  // of the rest of the record, not of it
        const bool everywhere = fault.from_s == 0.0 && fault.to_s == 0.0;
        const auto known = std::find_if(seen.begin(), seen.end(), [&](const SeenFault& other) {
            return everywhere && other.everywhere && other.fault.kind == fault.kind &&
                   other.fault.channels == fault.channels && other.fault.severity == fault.severity;
        });
        if (known != seen.end()) {
            ++known->sections;
            known->fault.to_s = start_s + section.duration_s;
            continue;
        }
        seen.push_back({fault, everywhere, 1});
        seen.back().fault.from_s += start_s;
        seen.back().fault.to_s += everywhere ? start_s + section.duration_s : start_s;
    }
}

std::vector<Fault> told_once(const std::vector<SeenFault>& seen, int sections) {
    std::vector<Fault> faults;
    for (const SeenFault& one : seen) {
        faults.push_back(one.fault);
        Fault& fault = faults.back();
        if (!one.everywhere) continue;
        if (one.sections == sections) fault.from_s = fault.to_s = 0.0;
        if (one.sections > 1) fault.says += fmt::format("; the same in {} of {} sections", one.sections, sections);
    }
    sort_faults(faults);
    return faults;
}

/// `judged`: the section had spectra; what a short rest could not check by itself is not said of the whole.
void join(const InspectionReport& one, bool judged, InspectionReport& all) {
    const double share = one.duration_s / std::max(1e-300, all.duration_s + one.duration_s);
    join_speed(one, share, all);
    all.samples += one.samples;
    all.duration_s += one.duration_s;
    for (std::size_t i = 0; i < all.channels.size(); ++i) join_channel(one.channels[i], share, all.channels[i]);
    for (const std::string& words : one.not_checked)
        if (judged && std::find(all.not_checked.begin(), all.not_checked.end(), words) == all.not_checked.end())
            all.not_checked.push_back(words);
    for (const std::string& note : one.notes)
        if (std::find(all.notes.begin(), all.notes.end(), note) == all.notes.end()) all.notes.push_back(note);
}

}  // namespace

InspectionReport inspect(const Recording& recording, const InspectionContext& context) {
    InspectedSection section = inspect_section(recording, context);
    if (section.spectra) describe_spectra(*section.spectra, section.report);
    name_lines(context, section.report);
    return std::move(section.report);
}

InspectionReport inspect_file(const RecordingDescription& description, const std::filesystem::path& base,
                              const InspectionContext& context, std::size_t samples) {
    std::optional<InspectionReport> all;
    std::optional<CrossSpectra> spectra;
    std::vector<SeenFault> seen;
    int sections = 0;
    load_in_sections(description, base, samples, [&](const Recording& recording) {
        InspectedSection section = inspect_section(recording, context);
        ++sections;
        add_faults(section.report, recording.series.start_s, seen);
        const bool judged = section.spectra.has_value();
        if (judged) spectra = spectra ? merged({*spectra, *section.spectra}) : std::move(*section.spectra);
        if (all)
            join(section.report, judged, *all);
        else
            all = std::move(section.report);
    });
    if (spectra) describe_spectra(*spectra, *all);
    name_lines(context, *all);
    if (sections > 1) {
        all->faults = told_once(seen, sections);
        all->notes.push_back(fmt::format(
            "inspected in {} sections of {:.0f} s: spectra, bands, lines and coherence are of all of them, the "
            "spectrogram is of the first",
            sections, static_cast<double>(samples) / all->sampling_rate_hz));
    }
    return std::move(*all);
}

}  // namespace railpem::recordings

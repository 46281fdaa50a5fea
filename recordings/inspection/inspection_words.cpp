#include "recordings/inspection/inspection_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>

namespace railpem::recordings {

std::string place_words(const ChannelDescription& channel) {
    static const char* const names[] = {"-", "body", "bogie", "wheel", "rail"};
    std::string words = names[static_cast<int>(channel.location)];
    if (channel.index > 0) words += fmt::format(" {}", channel.index);
    if (channel.location == Location::body) words += fmt::format(" {:+g} m", channel.position_m);
    if (channel.side != Side::unstated) words += channel.side == Side::left ? " left" : " right";
    return words;
}

std::string fault_place(const Fault& fault) {
    std::string words = fault.channels.empty() ? "whole record" : fmt::format("{}", fmt::join(fault.channels, ", "));
    if (fault.to_s > fault.from_s)
        words += fmt::format(", {:.2f}–{:.2f} s", fault.from_s, fault.to_s);
    else if (fault.from_s > 0.0)
        words += fmt::format(", {:.2f} s", fault.from_s);
    return words;
}

std::string speed_words(const InspectionReport& report) {
    std::string words;
    if (report.stated_speed_m_per_s > 0.0)
        words = fmt::format("Speed: {:.4g} m/s ({:.4g} km/h) stated{}", report.stated_speed_m_per_s,
                            3.6 * report.stated_speed_m_per_s,
                            report.stated_speed_error_m_per_s > 0.0
                                ? fmt::format(" ± {:.2g}", 1.645 * report.stated_speed_error_m_per_s)
                                : "");
    if (report.speed_m_per_s > 0.0)
        words += fmt::format("{}{:.5g} ± {:.2g} m/s by the delays of {} pair{} of channels (90 %)",
                             words.empty() ? "Speed: " : ", ", report.speed_m_per_s, 1.645 * report.speed_error_m_per_s,
                             report.speed_pairs, report.speed_pairs > 1 ? "s" : "");
    const SpeedAlong& along = report.speed_along;
    if (!along.read_from.empty() && along.read_from != "description")
        words += fmt::format("{}{:.4g} m/s in the mean, {:.4g} to {:.4g} m/s along the record, by the {}",
                             words.empty() ? "Speed: " : "; ", along.mean_m_per_s, along.lowest_m_per_s,
                             along.highest_m_per_s, along.read_from);
    if (report.wheel_orders) {
        const WheelOrders& w = *report.wheel_orders;
        const double speed = report.speed_m_per_s > 0.0 ? report.speed_m_per_s : report.stated_speed_m_per_s;
        words += fmt::format("{}{} of {} lines are multiples of {:.4f} Hz: wheels of {:.3f} m radius at this speed",
                             words.empty() ? "" : ". ", w.orders.size(), w.lines, w.rotation_hz,
                             speed / (2.0 * std::numbers::pi * w.rotation_hz));
    }
    return words.empty() ? "" : words + ".";
}

std::string unit_words(const InspectionReport& report) {
    std::vector<std::pair<std::string, std::vector<std::string>>> groups;  // channels of which the same is said
    const auto add = [&](const std::string& says, const std::string& name) {
        if (says.empty()) return;
        auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& known) { return known.first == says; });
        if (group == groups.end()) group = groups.insert(groups.end(), {says, {}});
        group->second.push_back(name);
    };
    for (const ChannelInspection& channel : report.channels) add(channel.unit_says, channel.description.name);
    for (const ChannelSpectrum& spectrum : report.spectra) add(spectrum.unit_says, spectrum.description.name);
    if (groups.empty()) return "";
    std::vector<std::string> words;
    for (const auto& [says, names] : groups)
        words.push_back(groups.size() == 1 ? says : fmt::format("{} in {}", says, fmt::join(names, ", ")));
    return fmt::format("Numbers in the file: {}.", fmt::join(words, "; "));
}

std::string averages_words(const InspectionReport& report) {
    if (report.frequency_hz.empty()) return "";
    return fmt::format(
        "Spectra: 2 s Hann windows, 50 % overlap, {:.1f} independent averages: a bin is known to {:+.1f}/{:+.1f} dB "
        "(90 %); coherence above {:.2f} is significant (5 %).",
        report.averages, report.interval_low_db, report.interval_high_db, report.coherence_limit);
}

std::string irregularity_words(const InspectionReport& report) {
    const MeasuredIrregularity& brought = report.irregularity;
    if (!brought.brought()) return "";
    const double low = 1.0 / brought.longest_wavelength_m(), high = 1.0 / brought.shortest_wavelength_m();
    const double speed = report.speed_m_per_s > 0.0 ? report.speed_m_per_s : report.stated_speed_m_per_s;
    return fmt::format(
        "Irregularity: a measured {}. It covers wavelengths from {:.3g} m to {:.3g} m{}; outside them nothing was "
        "measured.",
        report.profile_length_m > 0.0
            ? fmt::format("profile of {:.4g} m in steps of {:.3g} m, {:.3g} mm rms; its spectrum from segments of "
                          "{:.3g} m, {:.1f} independent averages",
                          report.profile_length_m, report.profile_step_m, 1e3 * report.profile_rms_m,
                          brought.segment_length_m, brought.averages)
            : fmt::format("spectrum of {} values", brought.psd_m3.size()),
        1.0 / high, 1.0 / low,
        speed > 0.0
            ? fmt::format(", at {:.4g} m/s frequencies from {:.3g} Hz to {:.4g} Hz", speed, speed * low, speed * high)
            : "; no speed is known, so no frequencies");
}

std::vector<TableFact> table_facts(const InspectionReport& report) {
    std::vector<TableFact> facts;
    for (const ChannelSpectrum& s : report.spectra)
        if (!s.frequency_hz.empty())
            facts.push_back(
                {s.description.name,
                 fmt::format("{} values, {:g} to {:g} Hz{}", s.psd.size(), s.frequency_hz.front(),
                             s.frequency_hz.back(), s.standard_error.empty() ? "" : ", with standard errors")});
    const auto& frequency = report.receptance.frequency_hz;
    if (!frequency.empty())
        facts.push_back({"receptance",
                         fmt::format("{} values, {:g} to {:g} Hz, {}", frequency.size(), frequency.front(),
                                     frequency.back(), report.receptance.has_phase ? "with phase" : "magnitude only")});
    if (!report.decay_rate.centre_hz.empty())
        facts.push_back(
            {"decay rate",
             fmt::format("{} bands, {:g} to {:g} Hz{}", report.decay_rate.centre_hz.size(),
                         report.decay_rate.centre_hz.front(), report.decay_rate.centre_hz.back(),
                         report.decay_rate.standard_error_db_per_m.empty() ? "" : ", with standard errors")});
    return facts;
}

std::string verdict_of(const InspectionReport& report) {
    if (report.kind != RecordingKind::timeseries && report.faults.empty())
        return "Read. Faults of the sensors cannot be looked for in this kind of data.";
    const auto count = [&](Severity severity) {
        return std::count_if(report.faults.begin(), report.faults.end(),
                             [&](const Fault& fault) { return fault.severity == severity; });
    };
    const auto kinds = [&](Severity severity) {
        std::vector<std::string> names;
        for (const Fault& fault : report.faults)
            if (fault.severity == severity &&
                std::find(names.begin(), names.end(), fault_name(fault.kind)) == names.end())
                names.push_back(fault_name(fault.kind));
        return fmt::format("{}", fmt::join(names, ", "));
    };
    const auto errors = count(Severity::error), warnings = count(Severity::warning);
    if (errors > 0)
        return fmt::format("Not to be trusted as it is: {} error{} ({}), {} warning{}.", errors, errors > 1 ? "s" : "",
                           kinds(Severity::error), warnings, warnings == 1 ? "" : "s");
    if (warnings > 0)
        return fmt::format("Usable with care: {} warning{} ({}).", warnings, warnings > 1 ? "s" : "",
                           kinds(Severity::warning));
    return "No fault was found.";
}

}  // namespace railpem::recordings

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recordings/files/visible_text.hpp"
#include "recordings/inspection/inspection_words.hpp"
#include "recordings/inspection/inspection_writers.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {
namespace {

constexpr std::size_t width = 100;

/// Words broken at `width`, every line after the first indented.
std::string wrapped(const std::string& text, std::size_t indent) {
    std::string out, line;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        if (!line.empty() && line.size() + 1 + word.size() > width) {
            out += line + "\n";
            line = std::string(indent, ' ') + word;
        } else {
            line += (at == 0 ? "" : " ") + word;
        }
        at = end + 1;
    }
    return out + line + "\n";
}

std::string channel_lines(const InspectionReport& report) {
    std::string out = fmt::format("{:<16.16} {:<10} {:>7} {:>10} {:>10} {:>10} {:>10} {:>6}\n", "channel", "at", "unit",
                                  "rms", "peak", "mean", "noise <", "kurt.");
    constexpr std::size_t most = 16;
    for (std::size_t i = 0; i < std::min(most, report.channels.size()); ++i) {
        const ChannelInspection& c = report.channels[i];
        out += fmt::format("{:<16.16} {:<10} {:>7} {:>10.4g} {:>10.4g} {:>10.3g} {:>10} {:>6.1f}\n", c.description.name,
                           place_words(c.description),
                           c.description.scale == Scale::unknown ? "?" : si_unit(c.description.quantity), c.rms, c.peak,
                           c.mean, std::isnan(c.noise_rms) ? "-" : fmt::format("{:.3g}", c.noise_rms), c.kurtosis);
    }
    if (report.channels.size() > most) out += fmt::format("… and {} more\n", report.channels.size() - most);
    return out;
}

std::string band_line(const InspectionReport& report) {
    if (report.channels.empty() || report.channels[0].bands.empty()) return "";
    std::string out = "Independent averages per third-octave (fewest of all channels):";
    for (std::size_t b = 0; b < report.channels[0].bands.size(); b += 3) {
        double least = 1e300;
        for (const ChannelInspection& c : report.channels)
            if (b < c.bands.size()) least = std::min(least, c.bands[b].averages);
        out += fmt::format(" {:g} Hz {:.0f},", report.channels[0].bands[b].band.nominal_hz, least);
    }
    out.back() = '.';
    return wrapped(out, 2);
}

std::string line_words(const InspectionReport& report) {
    std::string out;
    int count = 0;
    for (const ChannelInspection& c : report.channels)
        for (std::size_t i = 0; i < c.lines.size(); ++i, ++count)
            if (count < 6)
                out += fmt::format(" {:.2f} Hz in {} ({:.3g} rms{}),", c.lines[i].frequency_hz, c.description.name,
                                   std::sqrt(c.lines[i].mean_square),
                                   c.line_names[i].empty() ? "" : ": " + c.line_names[i]);
    if (out.empty()) return "";
    out.back() = '.';
    return wrapped("Lines:" + out + (count > 6 ? fmt::format(" … {} in all.", count) : ""), 2);
}

std::string table_words(const InspectionReport& report) {
    std::string out;
    for (const TableFact& table : table_facts(report)) out += fmt::format("{:<16} {}\n", table.name, table.holds);
    return out;
}

}  // namespace

std::string to_text(const InspectionReport& report) {
    std::string out = report.title.empty() ? "" : report.title + "\n";
    out += report.file + "\n";
    if (report.kind == RecordingKind::timeseries)
        out += fmt::format("{} channels at {:g} Hz, {:.4g} s ({} samples each)\n", report.channels.size(),
                           report.sampling_rate_hz, report.duration_s, report.samples);
    if (!report.start.empty()) out += fmt::format("from {}\n", report.start);
    out += "\n" + verdict_of(report) + "\n\n";
    for (const std::string& words :
         {unit_words(report), speed_words(report), averages_words(report), irregularity_words(report)})
        if (!words.empty()) out += wrapped(words, 2);
    out += band_line(report) + line_words(report);
    out += report.channels.empty() ? table_words(report) : "\n" + channel_lines(report);
    if (!report.faults.empty()) out += "\n";
    constexpr std::size_t most = 20;
    for (std::size_t i = 0; i < std::min(most, report.faults.size()); ++i) {
        const Fault& fault = report.faults[i];
        out += wrapped(
            fmt::format("{:<7} {} {}{}: {}", severity_name(fault.severity), fault_name(fault.kind), fault_place(fault),
                        fault.false_alarm > 1e-4 ? fmt::format(" (false alarm {:.1g})", fault.false_alarm) : "",
                        fault.says),
            10);
    }
    if (report.faults.size() > most)
        out += fmt::format("… and {} more (--json has all)\n", report.faults.size() - most);
    const auto list = [&](const char* heading, const std::vector<std::string>& items) {
        if (items.empty()) return;
        out += std::string("\n") + heading + "\n";
        for (const std::string& item : items) out += wrapped("- " + item, 2);
    };
    list("Not checked", report.not_checked);
    list("What this recording cannot tell", report.lacks);
    list("Notes", report.notes);
    return visible_lines(out);  // names and words of the data file are among it
}

}  // namespace railpem::recordings

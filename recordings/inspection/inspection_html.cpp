#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "recordings/inspection/inspection_charts.hpp"
#include "recordings/inspection/inspection_words.hpp"
#include "recordings/inspection/inspection_writers.hpp"
#include "recordings/page/page_parts.hpp"
#include "recordings/page/page_text.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {
namespace {

std::string list(const std::string& heading, const std::vector<std::string>& items) {
    if (items.empty()) return "";
    std::string out = "<h2>" + heading + "</h2><ul class=\"plain\">";
    for (const std::string& item : items) out += "<li>" + escaped(item) + "</li>";
    return out + "</ul>\n";
}

std::string facts(const InspectionReport& report) {
    const auto fact = [](const std::string& name, const std::string& value) {
        return "<li>" + name + "<b>" + escaped(value) + "</b></li>";
    };
    if (report.kind != RecordingKind::timeseries) {
        std::string tables = "<ul class=\"facts\">";
        for (const TableFact& table : table_facts(report)) tables += fact(escaped(table.name), table.holds);
        return tables + "</ul>\n";
    }
    std::string out = "<ul class=\"facts\">" +
                      fact("Channels", fmt::format("{} at {:g} Hz", report.channels.size(), report.sampling_rate_hz)) +
                      fact("Length", fmt::format("{:.4g} s, {} samples", report.duration_s, report.samples));
    if (!report.start.empty()) out += fact("From", report.start);
    if (report.stated_speed_m_per_s > 0.0)
        out += fact("Speed as stated", fmt::format("{:.4g} m/s = {:.4g} km/h", report.stated_speed_m_per_s,
                                                   3.6 * report.stated_speed_m_per_s));
    if (report.speed_m_per_s > 0.0)
        out += fact(fmt::format("Speed by the delays of {} pairs", report.speed_pairs),
                    fmt::format("{:.5g} ± {:.2g} m/s", report.speed_m_per_s, 1.645 * report.speed_error_m_per_s));
    if (report.averages > 0.0)
        out += fact("Independent averages of a bin", fmt::format("{:.1f}: {:+.1f} / {:+.1f} dB (90 %)", report.averages,
                                                                 report.interval_low_db, report.interval_high_db));
    if (report.wheel_orders)
        out += fact(
            "Wheel rotation by its multiples",
            fmt::format("{:.4f} Hz, {} lines", report.wheel_orders->rotation_hz, report.wheel_orders->orders.size()));
    return out + "</ul>\n";
}

std::string fault_table(const InspectionReport& report) {
    if (report.kind != RecordingKind::timeseries) return "";
    std::string out = "<h2>Faults</h2>";
    if (report.faults.empty()) return out + "<p>None was found.</p>\n";
    out +=
        "<div class=\"scroll\"><table><thead><tr><th>How bad</th><th>What</th><th>Where</th><th>Finding</th><th "
        "class=\"number\" title=\"probability that a sound record shows as much\">By chance</th></tr></thead><tbody>\n";
    for (const Fault& fault : report.faults)
        out += fmt::format(
            "<tr><td class=\"severity {0}\">{0}</td><td>{1}</td><td>{2}</td><td>{3}</td><td "
            "class=\"number\">{4}</td></tr>\n",
            severity_name(fault.severity), fault_name(fault.kind), escaped(fault_place(fault)), escaped(fault.says),
            fault.false_alarm <= 0.0   ? "–"
            : fault.false_alarm < 1e-4 ? "&lt; 1e-4"
                                       : fmt::format("{:.1g}", fault.false_alarm));
    return out + "</tbody></table></div>\n";
}

std::string channel_table(const InspectionReport& report) {
    if (report.channels.empty()) return "";
    std::string out =
        "<h2>Channels</h2><div class=\"scroll\"><table><thead><tr><th>Name</th><th>At</th><th>Unit</th><th "
        "class=\"number\">rms</th><th class=\"number\">Peak</th><th class=\"number\">Mean</th><th "
        "class=\"number\">Noise at most</th><th class=\"number\" title=\"3 for a random channel\">Kurtosis"
        "</th><th>Lines</th></tr></thead><tbody>\n";
    for (const ChannelInspection& c : report.channels) {
        std::string lines;
        for (std::size_t i = 0; i < c.lines.size() && i < 5; ++i)
            lines += fmt::format("{}{:.2f} Hz{}", lines.empty() ? "" : ", ", c.lines[i].frequency_hz,
                                 c.line_names[i].empty() ? "" : " (" + c.line_names[i] + ")");
        if (c.lines.size() > 5) lines += fmt::format(", … {} in all", c.lines.size());
        out += fmt::format(
            "<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"number\">{:.4g}</td><td class=\"number\">{:.4g}</td><td "
            "class=\"number\">{:.3g}</td><td class=\"number\">{}</td><td "
            "class=\"number\">{:.1f}</td><td>{}</td></tr>\n",
            escaped(c.description.name), place_words(c.description),
            c.description.scale == Scale::unknown ? "unknown" : si_unit(c.description.quantity), c.rms, c.peak, c.mean,
            std::isnan(c.noise_rms) ? "–" : fmt::format("{:.3g}", c.noise_rms), c.kurtosis,
            lines.empty() ? "–" : escaped(lines));
    }
    return out + "</tbody></table></div>\n";
}

std::string chart_places(const nlohmann::json& data) {
    std::string out;
    for (const auto& chart : data["charts"]) {
        const std::string id = chart["id"];
        const std::string heading = id == "coherence"      ? "Coherence"
                                    : id == "receptance"   ? "Receptance"
                                    : id == "decay"        ? "Track decay rate"
                                    : id == "irregularity" ? "Measured irregularity"
                                                           : "Spectra";
        out += fmt::format(
            "<h2>{0}</h2><div class=\"chart{1}\"><canvas id=\"{2}\" role=\"img\" aria-label=\"{0}\"></canvas></div>\n",
            heading, id == "coherence" ? " low" : "", id);
    }
    return out;
}

}  // namespace

std::string to_html(const InspectionReport& report) {
    const nlohmann::json data = chart_data(report);
    const std::string title = report.title.empty() ? report.file : report.title;
    std::string severity;
    for (const Fault& fault : report.faults)
        if (severity.empty() && fault.severity != Severity::note)
            severity = severity_name(fault.severity);  // errors come first
    std::string out = page_head(title, inspection_style());
    out += "<h1>" + escaped(title) + "</h1><p class=\"soft\">" + escaped(report.file) + "</p>\n";
    out += "<p class=\"verdict " + severity + "\">" + verdict_of(report) + "</p>\n" + facts(report) +
           fault_table(report) + channel_table(report);
    if (const std::string words = unit_words(report); !words.empty()) out += "<p>" + escaped(words) + "</p>\n";
    if (const std::string words = irregularity_words(report); !words.empty()) out += "<p>" + escaped(words) + "</p>\n";
    out += chart_places(data);
    if (!report.spectrograms.empty()) out += "<h2>Spectrograms</h2>\n";
    for (const Spectrogram& spectrogram : report.spectrograms) {
        Spectrogram safe = spectrogram;
        safe.channel = escaped(spectrogram.channel);
        out += spectrogram_svg(safe, report);
    }
    out += list("Not checked", report.not_checked) + list("What this recording cannot tell", report.lacks) +
           list("Notes", report.notes);
    const std::string words = averages_words(report);
    out += "<footer><p>" + escaped(words) +
           (report.named_frequencies.empty() ? "" : " Dashed lines mark frequencies that have a name at this speed.") +
           " Charts: Chart.js (MIT licence).</p></footer>\n" + page_end(data, "pageCharts(pageData());\n");
    return out;
}

}  // namespace railpem::recordings

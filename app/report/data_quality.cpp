#include <fmt/format.h>

#include "app/report/sections.hpp"
#include "app/report/words.hpp"
#include "recordings/page/page_text.hpp"

namespace railpem::app::report {
namespace {

using diagnosis::Diagnosis;
using diagnosis::UsedRecording;
using recordings::escaped;

std::string recording_row(const UsedRecording& r) {
    const std::string stated =
        r.stated_speed_m_per_s > 0.0 ? figure(r.stated_speed_m_per_s, 4) + " stated" : "not stated";
    return fmt::format(
        "<tr><td>{}</td><td class=\"number\">{} m/s ({} to {}; {})</td><td class=\"number\">{} kg</td><td "
        "class=\"number\">{} s, of these {} s "
        "unseen</td><td class=\"number\">{}–{} Hz</td><td class=\"number\">{} of {} s</td><td "
        "class=\"number\">{}</td><td>{}</td></tr>\n",
        escaped(r.name), figure(r.speed_m_per_s, 4), figure(r.speed_low, 4), figure(r.speed_high, 4), stated,
        figure(r.payload_kg, 4), figure(r.seconds, 4), figure(r.held_out_seconds, 4), figure(r.low_hz),
        figure(r.high_hz), figure(r.averages), figure(r.window_s), r.channels.size(),
        r.irregularity_measured ? "measured" : "believed");
}

/// "recording: item" for what each recording lists.
std::vector<std::string> with_names(const Diagnosis& diagnosis, std::vector<std::string> UsedRecording::*list) {
    std::vector<std::string> out;
    for (const UsedRecording& r : diagnosis.recordings)
        for (const std::string& item : r.*list)
            out.push_back(diagnosis.recordings.size() > 1 ? r.name + ": " + item : item);
    return out;
}

std::string block(const std::string& heading, const std::vector<std::string>& items, const std::string& none) {
    if (!items.empty()) return fmt::format("<h3>{}</h3>\n", heading) + plain_list(items);
    return none.empty() ? "" : fmt::format("<h3>{}</h3>\n<p>{}</p>\n", heading, none);
}

}  // namespace

std::string data_quality(const Diagnosis& diagnosis) {
    std::string out = "<h2>The data</h2>\n";
    if (!diagnosis.recordings.empty()) {
        out +=
            "<div class=\"scroll\"><table><thead><tr><th>Recording</th><th class=\"number\">Speed as fitted (90 "
            "%)</th><th "
            "class=\"number\">Payload</th><th class=\"number\">Length</th><th class=\"number\">Band</th><th "
            "class=\"number\">Averages, "
            "window</th><th class=\"number\">Channels</th><th>Irregularity</th></tr></thead><tbody>\n";
        for (const UsedRecording& recording : diagnosis.recordings) out += recording_row(recording);
        out += "</tbody></table></div>\n";
    }
    out += block("Faults found", with_names(diagnosis, &UsedRecording::faults), "None.");
    out += block("Channels not used", with_names(diagnosis, &UsedRecording::channels_not_used), "None.");
    return out + block("Not tested", diagnosis.not_tested, "Every effect of the catalogue was tested.");
}

std::string doubts(const std::vector<std::string>& doubts) {
    std::vector<std::string> items;
    for (const std::string& doubt : doubts) items.push_back(doubt);
    return block("Values of the case that are hardly believed", items, "");
}

std::string inputs(const Provenance* provenance) {
    if (!provenance) return "";
    std::string out =
        "<p class=\"soft\">" + escaped(provenance->program) + "; files that were read, with their SHA-256:</p>\n<pre>";
    for (const InputFile& input : provenance->inputs)
        out += escaped((input.sha256.empty() ? "not kept" : input.sha256) + "  " + input.path) + "\n";
    return out + "</pre>\n";
}

std::string repeat(const Diagnosis& diagnosis, const std::string& command) {
    std::string out = "<h2>To repeat it</h2>\n<pre>" + escaped(command) + "</pre>\n<p class=\"soft\">";
    if (diagnosis.seconds_taken > 0.0) out += fmt::format("It took {} s. ", figure(diagnosis.seconds_taken));
    return out +
           "diagnosed.toml beside this page is the case with what was left out: <code>railpem solve</code> runs it. "
           "Numbers: "
           "diagnosis.json, parameters.csv, curves.csv and the spectra of each recording.</p>\n";
}

}  // namespace railpem::app::report

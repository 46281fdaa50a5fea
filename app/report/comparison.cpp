#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/chart_data.hpp"
#include "app/report/sections.hpp"
#include "app/report/words.hpp"
#include "recordings/page/page_text.hpp"

namespace railpem::app::report {
namespace {

using diagnosis::ChannelComparison;
using diagnosis::Diagnosis;
using recordings::escaped;

std::string title_of(const ChannelComparison& channel) {
    return escaped(channel.recording.empty() ? channel.channel : channel.channel + ", " + channel.recording);
}

std::string canvas(const std::string& id, const std::string& label, bool low) {
    return fmt::format("<div class=\"chart{}\"><canvas id=\"{}\" role=\"img\" aria-label=\"{}\"></canvas></div>\n",
                       low ? " low" : "", id, label);
}

std::string pair_of_charts(const std::string& which, const std::string& label) {
    return canvas(which + "_spectrum", label + ": spectra", false) +
           canvas(which + "_bands", label + ": third-octave level differences", true);
}

/// A misfit on a ground that grows darker with it.
std::string cell(double value_db) {
    const double shade = std::isfinite(value_db) ? std::clamp(value_db / 6.0, 0.0, 1.0) : 0.0;
    return fmt::format("<td class=\"number\" style=\"background:rgb(var(--warm) / {:.2f})\">{}</td>", 0.75 * shade,
                       decibels(value_db));
}

std::string misfit_table(const Diagnosis& diagnosis) {
    std::string out =
        "<div class=\"scroll\"><table><thead><tr><th>Channel</th><th>Recording</th><th class=\"number\">Speed</th><th "
        "class=\"number\">Believed</th><th class=\"number\">Retuned</th><th "
        "class=\"number\">Diagnosed</th></tr></thead><tbody>\n";
    for (const ChannelComparison& c : diagnosis.channels)
        out +=
            fmt::format("<tr><td>{}</td><td>{}</td><td class=\"number\">{} m/s</td>{}{}{}</tr>\n", escaped(c.channel),
                        escaped(c.recording), figure(c.speed_m_per_s), cell(rms_level_db(c.band_believed_db)),
                        cell(rms_level_db(c.band_retuned_db)), cell(rms_level_db(c.band_diagnosed_db)));
    return out + "</tbody></table></div>\n";
}

std::string selector(const Diagnosis& diagnosis) {
    std::string out = "<p><label>Channel <select id=\"channel\">";
    for (std::size_t i = 0; i < diagnosis.channels.size(); ++i)
        out += fmt::format("<option value=\"{}\">{}</option>", i, title_of(diagnosis.channels[i]));
    return out + "</select></label></p>\n";
}

/// How much a part of a curve changes from its first to its last frequency, for the sentence above the chart.
std::string change(const std::vector<std::complex<double>>& law) {
    if (law.size() < 2 || law.front().real() == 0.0) return "–";
    return fmt::format("{:+.0f} %", 100.0 * (law.back().real() / law.front().real() - 1.0));
}

}  // namespace

std::string comparison(const Diagnosis& diagnosis) {
    if (diagnosis.channels.empty()) return "";
    const ChannelComparison& worst = diagnosis.channels[worst_channel(diagnosis)];
    std::string out = "<h2>Recorded against simulated</h2>\n";
    out += fmt::format(
        "<p>Worst channel: <b>{}</b>. Root mean square of the third-octave differences: <i class=\"believed\">believed "
        "{}</i>, "
        "<i class=\"retuned\">retuned {}</i>{}.</p>\n",
        title_of(worst), decibels(rms_level_db(worst.band_believed_db)), decibels(rms_level_db(worst.band_retuned_db)),
        worst.band_diagnosed_db.empty()
            ? ""
            : ", <i class=\"diagnosed\">diagnosed " + decibels(rms_level_db(worst.band_diagnosed_db)) + "</i>");
    out += pair_of_charts("worst", "Worst channel");
    out += "<h3>Every channel</h3>\n" + selector(diagnosis) + pair_of_charts("chosen", "Chosen channel") +
           "<p class=\"soft\">Root mean square of the third-octave differences:</p>" + misfit_table(diagnosis);
    return out;
}

std::string inferred_curves(const Diagnosis& diagnosis) {
    if (diagnosis.curves.empty()) return "";
    std::string out = "<h2>The dynamic stiffness that the recordings infer</h2>\n";
    for (std::size_t i = 0; i < diagnosis.curves.size(); ++i) {
        const diagnosis::InferredCurve& curve = diagnosis.curves[i];
        if (curve.frequency_hz.empty()) continue;
        out += fmt::format(
            "<p>At <b>{}</b>, from {} to {} Hz, with no law assumed: the real part changes by {}; by the <i "
            "class=\"retuned\">retuned</i> law {}, by the <i class=\"diagnosed\">diagnosed</i> law {}.</p>\n",
            place_words(curve.element), figure(curve.frequency_hz.front()), figure(curve.frequency_hz.back()),
            change(curve.value), change(curve.retuned), change(curve.diagnosed));
        const std::string n = std::to_string(i), name = element_name(curve.element);
        out += "<div class=\"two\">" + canvas("curve_real_" + n, name + ": real part", true) +
               canvas("curve_imaginary_" + n, name + ": imaginary part", true) + "</div>\n";
    }
    return out;
}

}  // namespace railpem::app::report

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/sections.hpp"
#include "app/report/words.hpp"
#include "recordings/page/page_text.hpp"

namespace railpem::app::report {
namespace {

using diagnosis::Diagnosis;
using recordings::escaped;

/// What each recording alone would have the parameter be.
std::string by_recording_row(const diagnosis::FittedParameter& p) {
    if (p.by_recording.empty()) return "";
    std::string values;
    for (const diagnosis::RecordedValue& own : p.by_recording)
        values += (values.empty() ? "" : ", ") + escaped(own.recording) + " " + figure(own.value, 4);
    return fmt::format("<tr class=\"soft\"><td></td><td colspan=\"3\">by recording: {}</td></tr>\n", values);
}

std::string parameter_rows(const diagnosis::NamedEffect& effect) {
    std::string out;
    for (const diagnosis::FittedParameter& p : effect.parameters)
        out += fmt::format(
                   "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{} to {}</td><td>{}</td></tr>\n",
                   escaped(p.name), figure(p.value, 4), figure(p.low, 4), figure(p.high, 4),
                   p.unit == "1" ? "–" : escaped(p.unit)) +
               by_recording_row(p);
    return out;
}

std::string effect_card(const diagnosis::NamedEffect& effect) {
    std::string out =
        fmt::format("<article class=\"card\"><h3>{}{}</h3><p>{}</p>\n<p class=\"soft\">At {}; probability {}.</p>\n",
                    escaped(effect.instance.effect), choice_words(effect.instance), sentence(effect.says),
                    place_words(effect.element), percent(effect.probability));
    if (!effect.parameters.empty())
        out +=
            "<div class=\"scroll\"><table><thead><tr><th>Parameter</th><th class=\"number\">Value</th><th "
            "class=\"number\">90 % "
            "interval</th><th>Unit</th></tr></thead><tbody>" +
            parameter_rows(effect) + "</tbody></table></div>\n";
    if (!effect.source.empty()) out += "<p class=\"soft\">Source: " + escaped(effect.source) + "</p>";
    return out + "</article>\n";
}

std::string rms_bar(const std::string& name, const char* kind, double value_db, double largest_db) {
    const double width = std::isfinite(value_db) ? 100.0 * std::clamp(value_db / largest_db, 0.0, 1.0) : 0.0;
    return fmt::format(
        "<div class=\"bar\"><span>{}</span><span class=\"track\"><i class=\"{}\" "
        "style=\"width:{:.1f}%\"></i></span><span "
        "class=\"number\">{}</span></div>\n",
        name, kind, width, decibels(value_db));
}

/// Of a verdict that is held against a case which keeps what was believed: what retuning reaches that need not.
std::string freely_words(const diagnosis::FitFigures& freely) {
    return fmt::format(
        "retuned keeps what is given up within two tolerances of the belief; where it may leave it for what that costs "
        "it reaches {} and log-likelihood {}",
        decibels(freely.rms_db), figure(freely.log_likelihood_per_second));
}

std::string fit_bars(const Diagnosis& d, bool seen) {
    const auto& before = seen ? d.before : d.held_out_before;
    const auto& retuned = seen ? d.retuned : d.held_out_retuned;
    const auto& after = seen ? d.after : d.held_out_after;
    double largest = 0.5;  // dB: below this no bar should look long
    for (const diagnosis::FitFigures* fit :
         {&d.before, &d.retuned, &d.after, &d.held_out_before, &d.held_out_retuned, &d.held_out_after})
        if (std::isfinite(fit->rms_db)) largest = std::max(largest, fit->rms_db);
    std::string out = seen ? "<div class=\"panel\"><h3>On the data that were fitted</h3>"
                           : "<div class=\"panel\"><h3>On data that no fit has seen</h3>";
    out += rms_bar("believed", "believed", before.rms_db, largest) +
           rms_bar("retuned", "retuned", retuned.rms_db, largest) +
           rms_bar("diagnosed", "diagnosed", after.rms_db, largest);
    if (d.freely_retuned)
        out += "<p class=\"soft\">" +
               sentence(freely_words(seen ? d.freely_retuned->fitted : d.freely_retuned->held_out)) + "</p>\n";
    return out + fmt::format(
                     "<p class=\"soft\">Log-likelihood per {}{}: believed {}, retuned {}, "
                     "diagnosed "
                     "{}.</p></div>\n",
                     d.per_value ? "value" : "second",
                     seen ? ", 0 is the best possible" : ", to be compared with each other",
                     figure(before.log_likelihood_per_second), figure(retuned.log_likelihood_per_second),
                     figure(after.log_likelihood_per_second));
}

std::string rival_card(const diagnosis::Rival& rival) {
    std::string values;
    for (const diagnosis::EffectInstance& instance : rival.instances) {
        for (const auto& [name, text] : instance.choices)
            values += (values.empty() ? "" : ", ") + escaped(name + " " + text);
        for (const auto& [name, value] : instance.values)
            values += (values.empty() ? "" : ", ") + escaped(name) + " " + figure(value);
    }
    std::string out = fmt::format(
        "<article class=\"card\"><h3>{}</h3><p class=\"soft\">Probability {}, {} nats behind; on data unseen {} nats "
        "over retuning{}.</p>",
        set_words(rival.effects), percent(rival.probability), figure(rival.nats_behind), figure(rival.nats_held_out),
        values.empty() ? "" : "; " + values);
    if (!rival.why_not.empty()) out += "<p><b>Why not:</b> " + sentence(rival.why_not) + "</p>";
    if (!rival.would_separate.empty()) out += "<p><b>Would separate:</b> " + sentence(rival.would_separate) + "</p>";
    return out + "</article>\n";
}

}  // namespace

std::string left_out(const Diagnosis& diagnosis) {
    std::string out = "<h2>What was left out</h2>\n";
    if (diagnosis.omitted.empty()) {
        if (diagnosis.verdict == diagnosis::Verdict::consistent)
            return out + "<p>Nothing that these recordings could show.</p>\n";
        if (diagnosis.verdict == diagnosis::Verdict::ambiguous)
            return out +
                   fmt::format("<p>{} sets of effects explain it about equally well; they are the rivals below.</p>\n",
                               diagnosis.rivals.size());
        return out + "<p>No effect of the catalogue describes it; the nearest are the rivals below.</p>\n";
    }
    out += "<div class=\"cards\">";
    for (const diagnosis::NamedEffect& effect : diagnosis.omitted) out += effect_card(effect);
    return out + "</div>\n";
}

std::string explained_share(const Diagnosis& diagnosis) {
    const bool nothing = diagnosis.verdict == diagnosis::Verdict::consistent;
    std::string out = std::string(nothing ? "<h2>How well it fits</h2>" : "<h2>How much it explains</h2>") +
                      "\n<p>Root mean square over channels and third octaves of the level difference "
                      "between recording and model.</p>\n<div class=\"two\">" +
                      fit_bars(diagnosis, true) + fit_bars(diagnosis, false) + "</div>\n";
    if (diagnosis.omitted.empty()) return out;
    out +=
        "<div class=\"scroll\"><table><thead><tr><th>Effect</th><th class=\"number\">Nats on data seen</th><th "
        "class=\"number\">Nats on data unseen</th></tr></thead><tbody>\n";
    for (const diagnosis::NamedEffect& effect : diagnosis.omitted)
        out += fmt::format("<tr><td>{}{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n",
                           escaped(effect.instance.effect), choice_words(effect.instance), figure(effect.nats_fitted),
                           figure(effect.nats_held_out));
    return out +
           "</tbody></table></div>\n<p class=\"soft\">Nats: natural units of log-likelihood that the effect wins over "
           "the "
           "retuned case.</p>\n";
}

std::string rivals(const Diagnosis& diagnosis) {
    std::string out = "<h2>Rivals, and what would separate them</h2>\n";
    constexpr std::size_t kShown = 8;
    for (std::size_t i = 0; i < std::min(kShown, diagnosis.posterior.size()); ++i) {
        const diagnosis::EffectSet& set = diagnosis.posterior[i];
        out += fmt::format(
            "<div class=\"bar wide\"><span>{}</span><span class=\"track\"><i class=\"hot\" "
            "style=\"width:{:.1f}%\"></i></span><span "
            "class=\"number\">{}</span></div>\n",
            set_words(set.effects),
            std::isfinite(set.probability) ? 100.0 * std::clamp(set.probability, 0.0, 1.0) : 0.0,
            percent(set.probability));
    }
    if (diagnosis.rivals.empty()) return out + "<p>No other set of effects came near.</p>\n";
    out += "<div class=\"cards\">";
    for (const diagnosis::Rival& rival : diagnosis.rivals) out += rival_card(rival);
    return out + "</div>\n";
}

std::string remaining(const Diagnosis& diagnosis) {
    const std::string list = plain_list(diagnosis.remains);
    const double rms =
        std::isfinite(diagnosis.held_out_after.rms_db) ? diagnosis.held_out_after.rms_db : diagnosis.after.rms_db;
    return fmt::format("<h2>What remains unexplained</h2>\n<p>{} of misfit are left.{}</p>\n{}", decibels(rms),
                       list.empty() ? " Nothing in it is significant." : "", list);
}

}  // namespace railpem::app::report

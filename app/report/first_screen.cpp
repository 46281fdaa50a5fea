#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/heat_map.hpp"
#include "app/report/sections.hpp"
#include "app/report/vehicle_drawing.hpp"
#include "app/report/words.hpp"
#include "recordings/page/page_text.hpp"

namespace railpem::app::report {
namespace {

using diagnosis::Diagnosis;
using diagnosis::Verdict;
using recordings::escaped;

std::string tile(const std::string& name, const std::string& value, const std::string& more) {
    return "<li>" + name + "<b>" + value + "</b><span class=\"soft\">" + more + "</span></li>\n";
}

std::string misfit_tile(const Diagnosis& diagnosis) {
    const bool unseen = std::isfinite(diagnosis.held_out_after.rms_db);
    const auto& before = unseen ? diagnosis.held_out_before : diagnosis.before;
    const auto& retuned = unseen ? diagnosis.held_out_retuned : diagnosis.retuned;
    const auto& after = unseen ? diagnosis.held_out_after : diagnosis.after;
    const bool named = diagnosis.verdict != Verdict::consistent;  // or else the diagnosed case is the retuned one
    const auto coloured = [](const char* kind, double value) {
        const std::string text = decibels(value);
        return fmt::format("<i class=\"{0}\" title=\"{0}\">{1}</i>", kind, text.substr(0, text.find(' ')));
    };
    return tile(unseen ? "Misfit on data that no fit has seen" : "Misfit on the data that were fitted",
                coloured("believed", before.rms_db) + " → " + coloured("retuned", retuned.rms_db) +
                    (named ? " → " + coloured("diagnosed", after.rms_db) : "") + " dB",
                named ? "believed → retuned → diagnosed" : "believed → retuned");
}

std::string place_tile(const Diagnosis& diagnosis) {
    if (diagnosis.places.empty()) return "";
    std::string others;
    for (std::size_t i = 1; i < std::min<std::size_t>(diagnosis.places.size(), 3); ++i)
        others += (others.empty() ? "then " : ", ") + element_name(diagnosis.places[i].element) + " " +
                  percent(diagnosis.places[i].probability);
    return tile("Where", element_name(diagnosis.places[0].element) + " " + percent(diagnosis.places[0].probability),
                others);
}

std::string strength_tile(const Diagnosis& diagnosis) {
    if (diagnosis.omitted.empty() || diagnosis.omitted[0].parameters.empty()) return "";
    const diagnosis::FittedParameter& p = diagnosis.omitted[0].parameters[0];
    const std::string unit = p.unit == "1" ? "" : " " + escaped(p.unit);
    return tile(escaped(p.name), figure(p.value) + unit,
                fmt::format("90 %: {} to {}{}; {}", figure(p.low), figure(p.high), unit,
                            escaped(diagnosis.omitted[0].instance.effect)));
}

/// Of a case in which nothing is missing: what could be, and how likely.
std::string alternative_tile(const Diagnosis& diagnosis) {
    if (diagnosis.verdict != Verdict::consistent) return "";
    for (const diagnosis::EffectSet& set : diagnosis.posterior)
        if (!set.effects.empty())
            return tile("Strongest alternative", percent(set.probability), set_words(set.effects));
    return "";
}

std::string hidden_tile(const Diagnosis& diagnosis) {
    const auto outside = std::count_if(diagnosis.retuned_numbers.begin(), diagnosis.retuned_numbers.end(),
                                       [](const diagnosis::RetunedNumber& n) { return n.outside; });
    if (!std::isfinite(diagnosis.hidden_by_retuning))
        return tile("Retuned parameters outside their tolerance",
                    fmt::format("{} of {}", outside, diagnosis.retuned_numbers.size()), "");
    return tile("Hidden by retuning alone", percent(diagnosis.hidden_by_retuning),
                fmt::format("of the likelihood deficit; {} of {} parameters left their tolerance", outside,
                            diagnosis.retuned_numbers.size()));
}

/// What of the recordings the model does not have and no name is needed for: the first stands for the wheels.
std::string imperfection_tile(const Diagnosis& diagnosis) {
    if (diagnosis.imperfections.empty()) return "";
    const diagnosis::Imperfection* own = &diagnosis.imperfections.front();
    if (own->where != "wheel") return "";
    return tile("Met by each wheel alone", figure(100.0 * own->share_of_power, 2) + " %",
                "of the power of the irregularity; the rest all wheels meet one after the other");
}

/// Of what the verdict says: the named set, nothing, or something without a name. NaN where several sets are named.
double verdict_probability(const Diagnosis& diagnosis) {
    std::vector<std::string> named;
    for (const diagnosis::NamedEffect& effect : diagnosis.omitted) named.push_back(effect.instance.effect);
    const auto is_meant = [&](const diagnosis::EffectSet& set) {
        if (diagnosis.verdict == Verdict::consistent) return set.effects.empty();
        if (diagnosis.verdict == Verdict::explained || diagnosis.verdict == Verdict::recording_fault)
            return set.effects == named;
        return false;
    };
    const auto found = std::find_if(diagnosis.posterior.begin(), diagnosis.posterior.end(), is_meant);
    return found == diagnosis.posterior.end() ? std::nan("") : found->probability;
}

std::string badge(const Diagnosis& diagnosis) {
    const double probability = verdict_probability(diagnosis);
    std::string out = fmt::format("<span class=\"badge {0}\">{0}</span>", verdict_name(diagnosis.verdict));
    if (diagnosis.verdict != Verdict::ambiguous && std::isfinite(probability))
        out += fmt::format("<span class=\"soft\">probability {}</span>", percent(probability));
    if (diagnosis.interrupted) out += "<span class=\"badge interrupted\">interrupted: what is known so far</span>";
    return "<p class=\"badges\">" + out + "</p>\n";
}

std::string place_bars(const Diagnosis& diagnosis) {
    std::string out;
    for (std::size_t i = 0; i < std::min<std::size_t>(diagnosis.places.size(), 4); ++i) {
        const diagnosis::PlaceEvidence& place = diagnosis.places[i];
        const double width = std::isfinite(place.probability) ? 100.0 * std::clamp(place.probability, 0.0, 1.0) : 0.0;
        out += fmt::format(
            "<div class=\"bar\"><span>{}</span><span class=\"track\"><i class=\"hot\" "
            "style=\"width:{:.1f}%\"></i></span><span "
            "class=\"number\">{}{}</span></div>\n",
            // below 0 a free correction is worth nothing
            element_name(place.element), width, percent(place.probability),
            place.nats > 0.0 ? ", " + figure(place.nats) + " nats" : "");
    }
    return out;
}

}  // namespace

std::string first_screen(const Diagnosis& diagnosis) {
    std::string out = "<header class=\"hero " + verdict_name(diagnosis.verdict) + "\">" + badge(diagnosis) + "<h1>" +
                      headline(diagnosis) + "</h1>\n<p>" + escaped(diagnosis.statement) + "</p></header>\n";
    out += "<ul class=\"facts\">" + place_tile(diagnosis) + strength_tile(diagnosis) + misfit_tile(diagnosis) +
           alternative_tile(diagnosis) + hidden_tile(diagnosis) + imperfection_tile(diagnosis) + "</ul>\n";
    out += "<section class=\"where\"><div class=\"panel\"><h2>" +
           std::string(diagnosis.places.empty() ? "Vehicle and track" : "Where it is") + "</h2>" +
           vehicle_drawing(diagnosis) + place_bars(diagnosis);
    if (!diagnosis.rests_on.empty()) out += "<p>The verdict rests on:</p>" + plain_list(diagnosis.rests_on);
    out += "</div>\n";
    if (const std::string maps = heat_maps(diagnosis); !maps.empty())
        out += "<div class=\"panel\"><h2>Channel × frequency</h2>" + maps + "</div>\n";
    return out + "</section>\n";
}

std::string mismatch_table(const Diagnosis& diagnosis) {
    if (diagnosis.mismatch.empty())
        return "<p>No band of any channel differs from the retuned case beyond chance.</p>\n";
    constexpr std::size_t kShown = 10;
    std::string out =
        "<p>Outlined in the map: bands that differ from the <i class=\"retuned\">retuned</i> case beyond chance; "
        "dashed: the "
        "relation of two channels differs. The false alarm counts all channels and bands together.</p>\n"
        "<div class=\"scroll\"><table><thead><tr><th>Channel</th><th>Recording</th><th class=\"number\">Band</th><th "
        "class=\"number\">Recording over model</th><th class=\"number\">False "
        "alarm</th><th>Element</th></tr></thead><tbody>\n";
    for (std::size_t i = 0; i < std::min(kShown, diagnosis.mismatch.size()); ++i) {
        const diagnosis::Mismatch& m = diagnosis.mismatch[i];
        out += fmt::format(
            "<tr><td>{}{}</td><td>{}</td><td class=\"number\">{}–{} Hz</td><td class=\"number\">{}</td><td "
            "class=\"number\">{}</td><td>{}</td></tr>\n",
            escaped(m.channel), m.other_channel.empty() ? "" : " × " + escaped(m.other_channel),
            m.recording.empty() ? "all" : escaped(m.recording), figure(m.low_hz), figure(m.high_hz),
            decibels(m.level_db, true), chance(m.false_alarm_probability), element_name(m.element));
    }
    out += "</tbody></table></div>\n";
    if (diagnosis.mismatch.size() > kShown)
        out += fmt::format("<p class=\"soft\">The {} most certain of {}; all are in diagnosis.json.</p>\n", kShown,
                           diagnosis.mismatch.size());
    return out;
}

}  // namespace railpem::app::report

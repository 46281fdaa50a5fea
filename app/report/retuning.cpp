#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/sections.hpp"
#include "app/report/words.hpp"
#include "recordings/page/page_text.hpp"

namespace railpem::app::report {
namespace {

using diagnosis::Diagnosis;
using diagnosis::RetunedNumber;
using recordings::escaped;

constexpr std::size_t kShown = 12;

/// Largest departures first.
std::vector<RetunedNumber> ranked(std::vector<RetunedNumber> numbers) {
    std::erase_if(numbers, [](const RetunedNumber& n) { return !std::isfinite(n.tolerances_away); });
    std::stable_sort(numbers.begin(), numbers.end(), [](const RetunedNumber& a, const RetunedNumber& b) {
        return std::abs(a.tolerances_away) > std::abs(b.tolerances_away);
    });
    return numbers;
}

const RetunedNumber* find(const std::vector<RetunedNumber>& numbers, const std::string& key) {
    const auto at = std::find_if(numbers.begin(), numbers.end(), [&](const RetunedNumber& n) { return n.key == key; });
    return at == numbers.end() ? nullptr : &*at;
}

/// A bar from the middle, which is what was believed; the ends of the track are ±`span` tolerances.
std::string bar(const char* kind, double tolerances_away, double span) {
    const double reach = 50.0 * std::clamp(tolerances_away / span, -1.0, 1.0);
    return fmt::format("<i class=\"{}\" style=\"left:{:.1f}%;width:{:.1f}%\"></i>", kind, 50.0 + std::min(reach, 0.0),
                       std::abs(reach));
}

std::string change(const RetunedNumber& n) {
    return n.believed != 0.0 ? fmt::format("{:+.1f} %", 100.0 * (n.value / n.believed - 1.0)) : figure(n.value);
}

std::string flag(const RetunedNumber& n) {
    return n.outside ? "<b class=\"flag\">outside its tolerance</b>" : "";
}

std::string row(const RetunedNumber& retuned, const RetunedNumber* diagnosed, double span) {
    std::string out = fmt::format(
        "<div class=\"departure{}\"><p><code>{}</code> {}</p><div class=\"axis\"><u "
        "style=\"left:{:.1f}%;width:{:.1f}%\"></u>{}{}</div>",
        retuned.outside ? " outside" : "", escaped(retuned.key), flag(retuned), 50.0 - 100.0 / span, 200.0 / span,
        bar("retuned", retuned.tolerances_away, span),
        diagnosed ? bar("diagnosed second", diagnosed->tolerances_away, span) : "");
    out += fmt::format(
        "<p class=\"soft\"><i class=\"retuned\">retuned {} = {:+.1f} tolerances</i>: {} {} ({} to {}), believed {} ± "
        "{}",
        change(retuned), retuned.tolerances_away, figure(retuned.value), escaped(retuned.unit), figure(retuned.low),
        figure(retuned.high), figure(retuned.believed), percent(retuned.tolerance));
    if (diagnosed != nullptr)
        out += fmt::format("; <i class=\"diagnosed\">diagnosed {} = {:+.1f} tolerances</i>{}", change(*diagnosed),
                           diagnosed->tolerances_away, diagnosed->outside ? " " + flag(*diagnosed) : "");
    return out + "</p></div>\n";
}

std::string summary(const Diagnosis& diagnosis, std::size_t outside) {
    const std::string removed =
        std::isfinite(diagnosis.hidden_by_retuning)
            ? "removes <b>" + percent(diagnosis.hidden_by_retuning) + "</b> of the likelihood deficit and "
            : "";
    const bool kept = diagnosis.freely_retuned.has_value();
    std::string out =
        fmt::format("<p>Retuning the believed parameters, with nothing added, {}brings the misfit from {} to {}. ",
                    removed, decibels(diagnosis.before.rms_db),
                    decibels(kept ? diagnosis.freely_retuned->fitted.rms_db : diagnosis.retuned.rms_db));
    if (kept)
        out += fmt::format(
            "It leaves what was believed for that; where it keeps it within two tolerances, as everywhere else on this "
            "page, it gets to {}. ",
            decibels(diagnosis.retuned.rms_db));
    if (diagnosis.retuned_numbers.empty()) return out + "</p>\n";
    out += fmt::format("<b>{}</b> of {} parameters leave their tolerance for it", outside,
                       diagnosis.retuned_numbers.size());
    if (diagnosis.omitted.empty()) return out + ".</p>\n";
    const auto still = std::count_if(diagnosis.numbers.begin(), diagnosis.numbers.end(),
                                     [](const RetunedNumber& n) { return n.outside; });
    return out + fmt::format("; with what was left out in place, {} do.</p>\n", still);
}

}  // namespace

std::string hidden_share(const Diagnosis& diagnosis) {
    const std::vector<RetunedNumber> numbers = ranked(diagnosis.retuned_numbers);
    const auto outside = static_cast<std::size_t>(
        std::count_if(numbers.begin(), numbers.end(), [](const RetunedNumber& n) { return n.outside; }));
    std::string out = "<h2>What calibration would have hidden</h2>\n" + summary(diagnosis, outside);
    if (numbers.empty()) return out;
    double span = 3.0;
    for (const std::vector<RetunedNumber>* list : {&numbers, &diagnosis.numbers})
        for (const RetunedNumber& n : *list)
            if (std::isfinite(n.tolerances_away)) span = std::max(span, std::abs(n.tolerances_away));
    span = std::ceil(std::min(span, 20.0));
    const std::size_t shown = std::min(numbers.size(), std::max(outside, kShown));
    out += fmt::format(
        "<p class=\"soft\">Bars: how many tolerances a parameter moved, {:g} to either side; shaded: within "
        "two.</p>\n<div "
        "class=\"departures\">",
        span);
    for (std::size_t i = 0; i < shown; ++i)
        out += row(numbers[i], diagnosis.omitted.empty() ? nullptr : find(diagnosis.numbers, numbers[i].key), span);
    out += "</div>\n";
    if (shown < numbers.size())
        out +=
            fmt::format("<p class=\"soft\">{} more moved less than {:.2g} tolerances; all are in parameters.csv.</p>\n",
                        numbers.size() - shown, std::abs(numbers[shown - 1].tolerances_away));
    return out;
}

}  // namespace railpem::app::report

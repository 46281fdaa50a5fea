#include "effects/describe_effects.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <sstream>

#include "effects/catalogue.hpp"

namespace railpem::effects {

namespace {

constexpr const char* kIntroduction =
    "# Effects\n\n"
    "Physics that a believed case may have left out. Each effect can be switched on in a case file with a table, can "
    "be hidden in a\n"
    "simulated recording (`railpem simulate CASE --hide EFFECT:parameter=value,…`), and is a hypothesis of `railpem "
    "diagnose`. They\n"
    "combine, and the order in which they are listed does not matter. What adds to the case (an exponent, a friction "
    "force, a delay)\n"
    "adds to what the case has of it already. Parameters that are not stated take their typical value.\n\n"
    "```toml\n"
    "[[effect]]\n"
    "id = \"pad-frequency-stiffening\"\n"
    "exponent = 0.15\n"
    "```\n\n"
    "The bands are those of a subway car on a rigid track with elastic pads at 80 km/h. This page is printed by "
    "`railpem "
    "describe effects`.\n\n";

/// An item of a list, folded at 120 columns.
std::string item(const std::string& head, const std::string& text) {
    constexpr std::size_t kColumns = 120;
    std::string page, line = "- **" + head + "**:";
    std::stringstream words(text);
    for (std::string word; words >> word;) {
        if (line.size() + 1 + word.size() > kColumns) page += line + "\n", line = " ";
        line += " " + word;
    }
    return page + line + "\n";
}

std::string infinite_or_number(double value) {
    return std::isinf(value) ? "∞" : fmt::format("{:g}", value);
}

/// Text for a cell of a Markdown table.
std::string cell(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return text;
}

std::string elements_text(const EffectDescription& effect) {
    return place_text(effect, "where the value belongs");
}

std::string bands_text(const EffectDescription& effect) {
    std::vector<std::string> bands;
    for (const Band& band : effect.bands) bands.push_back(fmt::format("{:g}–{:g} Hz", band.low_hz, band.high_hz));
    return fmt::format("{}", fmt::join(bands, ", "));
}

std::string choice_text(const EffectChoice& choice) {
    std::string allowed = "any number of the case";
    if (choice.whole_number)
        allowed = fmt::format("{} to {}", choice.options.front(), choice.options.back());
    else if (!choice.options.empty())
        allowed = fmt::format("`{}`", fmt::join(choice.options, "`, `"));
    return fmt::format("| `{}` |  | {} | {} |  | {} |\n", choice.name, allowed,
                       choice.required ? "**required**" : fmt::format("instead of `{}`", choice.replaces), choice.says);
}

std::string parameter_text(const EffectParameter& parameter) {
    const std::string prior = parameter.spread == Spread::uniform ? "uniform" : "logarithmic";
    const std::string fades =
        parameter.strength ? fmt::format("; fades towards {}", infinite_or_number(parameter.nothing)) : "";
    return fmt::format("| `{}` | {} | {:g} to {:g} | {:g} | {} | {}{} |\n", parameter.name, parameter.unit,
                       parameter.low, parameter.high, parameter.typical, prior, cell(parameter.says), fades);
}

std::string effect_text(const EffectDescription& effect) {
    std::string page = fmt::format("## `{}`\n\nLeft out: {}.\n\n", effect.id, effect.says);
    page += "| parameter | unit | range | typical | prior | what it is |\n|---|---|---|---|---|---|\n";
    for (const EffectChoice& choice : effect.choices) page += choice_text(choice);
    for (const EffectParameter& parameter : effect.parameters) page += parameter_text(parameter);
    page += "\n" + item("Law", effect.equation + ".") +
            item("Place", elements_text(effect) + "; shows at " + bands_text(effect) + ".") +
            item("Mimics", effect.mimics) + (effect.not_told.empty() ? "" : item("Not told", effect.not_told + ".")) +
            item("Source", effect.source + ".") + "\n";
    page += fmt::format("![spectra with and without {0}](effects/{0}.png)\n\n", effect.id);
    return page;
}

}  // namespace

std::string describe_effects() {
    std::string page = kIntroduction, effects;
    page += "| effect | what was left out | place |\n|---|---|---|\n";
    for (const EffectDescription& effect : catalogue()) {
        if (effect.only_simulated) continue;
        page += fmt::format("| [`{0}`](#{0}) | {1} | {2} |\n", effect.id, cell(effect.says), elements_text(effect));
        effects += effect_text(effect);
    }
    effects.pop_back();
    return page + "\n" + effects;
}

}  // namespace railpem::effects

#include "simulate/effects/hidden_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "effects/catalogue.hpp"
#include "parameters/parameter_error.hpp"
#include "simulate/recording.hpp"

namespace railpem::simulate {

using parameters::ParameterError;

namespace {

/// Levenshtein distance: how many letters apart two names are.
std::size_t letters_apart(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
            diagonal = above;
        }
    }
    return row[b.size()];
}

/// "did you mean …? " for the nearest name, and all names.
std::string allowed_names(const std::string& wrong, const std::vector<std::string>& names) {
    std::string list;
    std::string nearest;
    std::size_t least = wrong.size() / 2 + 2;
    for (const std::string& name : names) {
        list += (list.empty() ? "" : ", ") + name;
        if (letters_apart(wrong, name) >= least) continue;
        least = letters_apart(wrong, name);
        nearest = name;
    }
    return nearest.empty() ? list : fmt::format("{} (did you mean {}?)", list, nearest);
}

HiddenParameter as_hidden(const effects::EffectChoice& choice) {
    HiddenParameter hidden{.name = choice.name, .unit = "", .says = choice.in_short};
    hidden.is_text = !choice.whole_number;
    if (hidden.is_text) return hidden;
    hidden.unit = "1";
    hidden.low = choice.simulated.low.value_or(std::stod(choice.options.front()));
    hidden.high = choice.simulated.high.value_or(std::stod(choice.options.back()));
    hidden.standard = choice.simulated.standard.value_or(choice.required ? hidden.low : 0.0);
    return hidden;
}

HiddenParameter as_hidden(const effects::EffectParameter& parameter) {
    return {.name = parameter.name,
            .unit = parameter.unit,
            .low = parameter.simulated.low.value_or(parameter.low),
            .high = parameter.simulated.high.value_or(parameter.high),
            .standard = parameter.simulated.standard.value_or(parameter.typical),
            .says = parameter.in_short.empty() ? parameter.says : parameter.in_short};
}

HiddenEffect as_hidden(const effects::EffectDescription& effect, HideInWorld apply) {
    HiddenEffect hidden{.id = effect.id,
                        .says = effect.in_short.empty() ? effect.says : effect.in_short,
                        .place = place_text(effect),
                        .only_here = effect.only_simulated,
                        .apply = std::move(apply)};
    for (const effects::EffectChoice& choice : effect.choices) hidden.parameters.push_back(as_hidden(choice));
    for (const effects::EffectParameter& parameter : effect.parameters)
        if (!parameter.law) hidden.parameters.push_back(as_hidden(parameter));
    for (const effects::EffectParameter& parameter : effect.only_simulated_parameters)
        hidden.parameters.push_back(as_hidden(parameter));
    return hidden;
}

/// The catalogue in the order of the list.
std::vector<HiddenEffect> listed_effects() {
    std::vector<const effects::EffectDescription*> order;
    for (const effects::EffectDescription& effect : effects::catalogue()) order.push_back(&effect);
    const auto row = [](const effects::EffectDescription* effect) {
        return effect->list_row > 0 ? effect->list_row : effect->row;
    };
    std::sort(order.begin(), order.end(), [&](const auto* a, const auto* b) { return row(a) < row(b); });
    const std::map<std::string, HideInWorld> in_world = effects_in_world();
    std::vector<HiddenEffect> list;
    for (const effects::EffectDescription* effect : order) list.push_back(as_hidden(*effect, in_world.at(effect->id)));
    std::stable_partition(list.begin(), list.end(), [](const HiddenEffect& effect) { return !effect.only_here; });
    return list;
}

const HiddenEffect& find(const std::string& id) {
    std::vector<std::string> names;
    for (const HiddenEffect& effect : hidden_effects()) {
        if (effect.id == id) return effect;
        names.push_back(effect.id);
    }
    throw ParameterError("--hide", fmt::format("no effect \"{}\"", id), allowed_names(id, names));
}

const HiddenParameter& find(const HiddenEffect& effect, const std::string& name) {
    std::vector<std::string> names;
    for (const HiddenParameter& parameter : effect.parameters) {
        if (parameter.name == name) return parameter;
        names.push_back(parameter.name);
    }
    throw ParameterError("--hide " + effect.id, fmt::format("no parameter \"{}\"", name), allowed_names(name, names));
}

double read_number(const std::string& key, const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        throw ParameterError(key, fmt::format("\"{}\" is not a number", text), "a number");
    return value;
}

/// Stores one `name=value`.
void read_value(const HiddenEffect& effect, const std::string& item, bool force, Hidden& hidden) {
    const std::size_t equals = item.find('=');
    const std::string name = item.substr(0, equals);
    const HiddenParameter& parameter = find(effect, name);
    const std::string key = fmt::format("--hide {}:{}", effect.id, name);
    if (equals == std::string::npos || equals + 1 == item.size())
        throw ParameterError(key, "no value", name + "=VALUE");
    if (hidden.values.has(name)) throw ParameterError(key, "given twice", "once");
    hidden.values.given.push_back(name);
    const std::string text = item.substr(equals + 1);
    if (parameter.is_text) {
        hidden.values.texts[name] = text;
        const std::vector<std::string>& channels = channel_names();
        if (name == "channel" && std::find(channels.begin(), channels.end(), text) == channels.end())
            throw ParameterError(key, fmt::format("no channel \"{}\"", text), allowed_names(text, channels));
        return;
    }
    const double value = read_number(key, text);
    const bool inside = value >= parameter.low && value <= parameter.high;
    if (!inside && !force)
        throw ParameterError(key, fmt::format("{:g} is outside the physical range", value),
                             fmt::format("between {:g} and {:g}{}, or --force", parameter.low, parameter.high,
                                         parameter.unit == "1" ? "" : " " + parameter.unit));
    hidden.forced = hidden.forced || !inside;
    hidden.values.numbers[name] = value;
}

}  // namespace

bool HiddenValues::has(const std::string& name) const {
    return std::find(given.begin(), given.end(), name) != given.end();
}

const std::vector<HiddenEffect>& hidden_effects() {
    static const std::vector<HiddenEffect> all = listed_effects();
    return all;
}

Hidden parse_hidden(const std::string& text, bool force) {
    const std::size_t colon = text.find(':');
    const HiddenEffect& effect = find(text.substr(0, colon));
    Hidden hidden{.id = effect.id, .values = {}};
    for (std::size_t at = colon; at != std::string::npos;) {
        const std::size_t comma = text.find(',', at + 1);
        const std::string item = text.substr(at + 1, comma == std::string::npos ? comma : comma - at - 1);
        if (!item.empty()) read_value(effect, item, force, hidden);
        at = comma;
    }
    for (const HiddenParameter& parameter : effect.parameters) {
        if (hidden.values.has(parameter.name)) continue;
        if (parameter.is_text)
            throw ParameterError(fmt::format("--hide {}:{}", effect.id, parameter.name), "missing", parameter.says);
        hidden.values.numbers[parameter.name] = parameter.standard;
    }
    return hidden;
}

void apply_hidden(const Hidden& hidden, pem::CaseParameters& parameters, OnlyHereParameters& only_here,
                  const ScaleParameter& scale) {
    find(hidden.id).apply(hidden.values, {.parameters = parameters, .only_here = only_here, .scale = scale});
}

std::string describe_hidden() {
    std::string text = "Effects that exist in `simulate` only; the diagnosis does not know their names.\n";
    for (const HiddenEffect& effect : hidden_effects()) {
        if (!effect.only_here) continue;
        text += fmt::format("\n`{}` ({}): {}\n", effect.id, effect.place, effect.says);
        for (const HiddenParameter& p : effect.parameters)
            text += fmt::format("- `{}` {:g} to {:g} {}, default {:g}: {}\n", p.name, p.low, p.high,
                                p.unit == "1" ? "" : p.unit, p.standard, p.says);
    }
    return text;
}

std::string hidden_json(const Hidden& hidden) {
    const HiddenEffect& effect = find(hidden.id);
    std::string values;
    for (const HiddenParameter& p : effect.parameters) {
        const std::string value = p.is_text ? fmt::format("\"{}\"", hidden.values.texts.at(p.name))
                                            : fmt::format("{:.17g}", hidden.values.numbers.at(p.name));
        values += fmt::format("{}\"{}\": {}", values.empty() ? "" : ", ", p.name, value);
    }
    return fmt::format(
        "{{\"effect\": \"{}\", \"place\": \"{}\", \"only_here\": {}, \"forced\": {}, \"parameters\": {{{}}}}}",
        hidden.id, effect.place, effect.only_here, hidden.forced, values);
}

}  // namespace railpem::simulate

#include "app/schema/hide_option.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/input_error.hpp"
#include "app/schema/case_numbers.hpp"
#include "app/schema/nearest_key.hpp"
#include "app/schema/schema.hpp"
#include "effects/catalogue.hpp"
#include "parameters/parameter_error.hpp"

namespace railpem::app {

using parameters::ParameterError;
using simulate::HiddenEffect;
using simulate::HiddenParameter;

namespace {

InputError refused_option(const ParameterError& error) {
    const std::string key = error.key().starts_with("--") ? error.key() : "--hide: " + error.key();
    return input_error("", "", {.option = key}, {.what = error.problem(), .allowed = error.allowed(), .hint = ""});
}

const HiddenEffect& find_effect(const std::string& option, const std::string& id) {
    std::vector<std::string> known;
    for (const HiddenEffect& effect : simulate::hidden_effects()) {
        if (effect.id == id) return effect;
        known.push_back(effect.id);
    }
    throw unknown_name(option, "effect", id, known);
}

/// Names of the parameters in "EFFECT:name=value,name=value".
std::vector<std::string> parameter_names(const std::string& text) {
    std::vector<std::string> names;
    for (std::size_t at = text.find(':'); at != std::string::npos;) {
        const std::size_t end = text.find(',', at + 1);
        const std::string item = text.substr(at + 1, end == std::string::npos ? end : end - at - 1);
        if (!item.empty()) names.push_back(item.substr(0, item.find('=')));
        at = end;
    }
    return names;
}

/// Unknown names get the message that every unknown key gets; values are for simulate::parse_hidden.
void check_names(const std::string& text) {
    const std::string option = "--hide " + text;
    const HiddenEffect& effect = find_effect(option, text.substr(0, text.find(':')));
    std::vector<std::string> known;
    for (const HiddenParameter& parameter : effect.parameters) known.push_back(parameter.name);
    for (const std::string& name : parameter_names(text))
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw unknown_name(option, "parameter", name, known);
}

/// Multiplies a number of the case, for the effect that is a wrong number.
void scale_number(pem::CaseParameters& parameters, const std::string& key, double factor) {
    const std::string option = fmt::format("--hide {}:parameter={}", effects::wrong_number_id(), key);
    std::vector<std::string> known;
    for (const CaseNumber& number : case_numbers(parameters)) {
        known.push_back(number.key);
        if (number.key != key_text(key_steps(key))) continue;
        const double value = number.get(parameters) * factor;
        if (!number.description.range.contains(value))
            throw input_error("", "", {.option = option},
                              {.what = fmt::format("{:g} times its value cannot be", factor),
                               .allowed = allowed_text(number.description),
                               .hint = ""});
        number.set(parameters, value);
        return;
    }
    throw input_error("", "", {.option = option},
                      {.what = "the case has no such number",
                       .allowed = "a dotted key of a number; railpem describe case lists them",
                       .hint = did_you_mean(key, known)});
}

std::string parameter_line(const HiddenParameter& p) {
    if (p.is_text) return fmt::format("    {:<28} text, required: {}\n", p.name, p.says);
    const std::string unit = p.unit == "1" ? "" : " " + p.unit;
    return fmt::format("    {:<28} {:g} to {:g}{}, default {:g}: {}\n", p.name, p.low, p.high, unit, p.standard,
                       p.says);
}

std::string effect_lines(const HiddenEffect& effect) {
    std::string text = fmt::format("\n{} ({}): {}\n", effect.id, effect.place, effect.says);
    for (const HiddenParameter& parameter : effect.parameters) text += parameter_line(parameter);
    return text;
}

}  // namespace

std::vector<simulate::Hidden> read_hide_options(const std::vector<std::string>& options, bool force) {
    std::vector<simulate::Hidden> hidden;
    for (const std::string& option : options) {
        check_names(option);
        try {
            hidden.push_back(simulate::parse_hidden(option, force));
        } catch (const ParameterError& error) {
            throw refused_option(error);
        }
    }
    return hidden;
}

CaseWithHidden hide_in_case(const pem::CaseParameters& believed, const std::vector<simulate::Hidden>& hidden) {
    CaseWithHidden with{.parameters = believed, .only_here = {}};
    try {
        for (const simulate::Hidden& effect : hidden)
            simulate::apply_hidden(effect, with.parameters, with.only_here, scale_number);
        pem::check(with.parameters);
    } catch (const ParameterError& error) {
        throw refused_option(error);
    }
    return with;
}

std::string effects_list() {
    std::string catalogue = "Effects that diagnose knows:\n",
                only_here = "\nEffects that exist only in simulate; diagnose does not know their names:\n";
    for (const HiddenEffect& effect : simulate::hidden_effects())
        (effect.only_here ? only_here : catalogue) += effect_lines(effect);
    return catalogue + only_here;
}

}  // namespace railpem::app

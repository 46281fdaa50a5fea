#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "diagnosis/effects/effect.hpp"
#include "parameters/parameter_error.hpp"

namespace railpem::diagnosis {

using parameters::ParameterError;

namespace {

const Effect& known_effect(const EffectInstance& instance) {
    if (const Effect* effect = find_effect(instance.effect)) return *effect;
    std::vector<std::string> ids;
    for (const Effect& effect : effects()) ids.push_back(effect.id);
    throw ParameterError("effect.id", fmt::format("there is no effect '{}'", instance.effect),
                         fmt::format("{}", fmt::join(ids, ", ")));
}

const EffectParameter* find_parameter(const Effect& effect, const std::string& name) {
    const auto found = std::find_if(effect.parameters.begin(), effect.parameters.end(),
                                    [&](const EffectParameter& parameter) { return parameter.name == name; });
    return found == effect.parameters.end() ? nullptr : &*found;
}

const EffectChoice* find_choice(const Effect& effect, const std::string& name) {
    const auto found = std::find_if(effect.choices.begin(), effect.choices.end(),
                                    [&](const EffectChoice& choice) { return choice.name == name; });
    return found == effect.choices.end() ? nullptr : &*found;
}

std::string options_text(const EffectChoice& choice) {
    if (choice.options.empty()) return "the dotted key of a number of the case";
    if (choice.whole_number)
        return fmt::format("a whole number between {} and {}", choice.options.front(), choice.options.back());
    return fmt::format("{}", fmt::join(choice.options, ", "));
}

[[noreturn]] void refuse_name(const Effect& effect, const std::string& name) {
    std::vector<std::string> names;
    for (const EffectChoice& choice : effect.choices) names.push_back(choice.name);
    for (const EffectParameter& parameter : effect.parameters) names.push_back(parameter.name);
    if (find_parameter(effect, name))
        throw ParameterError("effect." + name, fmt::format("'{}' of '{}' cannot be a text", name, effect.id),
                             "a number");
    if (const EffectChoice* choice = find_choice(effect, name))
        throw ParameterError("effect." + name, fmt::format("'{}' of '{}' is a choice", name, effect.id),
                             options_text(*choice));
    throw ParameterError("effect." + name, fmt::format("'{}' has no '{}'", effect.id, name),
                         fmt::format("{}", fmt::join(names, ", ")));
}

void check_value(const Effect& effect, const EffectParameter& parameter, double value, bool force) {
    const bool inside = value >= parameter.low && value <= parameter.high;  // false for NaN
    if (inside || (force && !std::isnan(value))) return;
    throw ParameterError("effect." + parameter.name,
                         fmt::format("'{}' of '{}' cannot be {:g}", parameter.name, effect.id, value),
                         fmt::format("a number between {:g} and {:g}{}", parameter.low, parameter.high,
                                     parameter.unit == "1" ? "" : ", in " + parameter.unit));
}

void check_choice(const Effect& effect, const EffectChoice& choice, const EffectInstance& instance,
                  const ParameterAccess& access) {
    const auto stated = instance.choices.find(choice.name);
    if (stated == instance.choices.end()) {
        if (!choice.required) return;
        throw ParameterError("effect." + choice.name,
                             fmt::format("'{}' needs '{}' ({})", effect.id, choice.name, choice.says),
                             options_text(choice));
    }
    const std::vector<std::string>& options = choice.options.empty() ? access.keys : choice.options;
    if (std::find(options.begin(), options.end(), stated->second) == options.end())
        throw ParameterError("effect." + choice.name,
                             fmt::format("'{}' of '{}' cannot be '{}'", choice.name, effect.id, stated->second),
                             options_text(choice));
    if (!choice.replaces.empty() && instance.values.count(choice.replaces) > 0)
        throw ParameterError("effect." + choice.name,
                             fmt::format("'{}' has both '{}' and '{}'", effect.id, choice.name, choice.replaces),
                             "one of them");
}

/// The instance with every parameter stated.
EffectInstance completed(const Effect& effect, EffectInstance instance) {
    for (const EffectParameter& parameter : effect.parameters)
        instance.values.emplace(parameter.name, parameter.typical);
    return instance;
}

}  // namespace

double value_of(const Effect& effect, const EffectInstance& instance, const std::string& name) {
    const EffectParameter* parameter = find_parameter(effect, name);
    if (!parameter) throw std::logic_error(effect.id + " has no parameter " + name);
    const auto stated = instance.values.find(name);
    return stated == instance.values.end() ? parameter->typical : stated->second;
}

Element element_of(const Effect& effect, const EffectInstance& instance) {
    if (effect.elements.size() == 1) return effect.elements.front();
    if (effect.wrong_number) return element_of_key(instance.choices.at("parameter"));
    for (const EffectChoice& choice : effect.choices) {
        if (!choice.is_element) continue;
        for (const Element element : effect.elements)
            if (element_name(element) == instance.choices.at(choice.name)) return element;
    }
    throw std::logic_error(effect.id + " does not say in which element it sits");
}

void check(const EffectInstance& instance, const ParameterAccess& access, bool force) {
    const Effect& effect = known_effect(instance);
    for (const auto& [name, value] : instance.values) {
        const EffectParameter* parameter = find_parameter(effect, name);
        if (!parameter) refuse_name(effect, name);
        check_value(effect, *parameter, value, force);
    }
    for (const auto& [name, unused] : instance.choices)
        if (!find_choice(effect, name)) refuse_name(effect, name);
    for (const EffectChoice& choice : effect.choices) check_choice(effect, choice, instance, access);
}

void apply(const EffectInstance& instance, const ParameterAccess& access, pem::CaseParameters& parameters, bool force) {
    check(instance, access, force);
    const Effect& effect = known_effect(instance);
    if (effect.obstacle)
        if (const std::optional<Obstacle> obstacle = effect.obstacle(parameters))
            throw ParameterError("effect.id", fmt::format("no '{}': {}", effect.id, obstacle->problem),
                                 obstacle->allowed);
    effect.apply(parameters, completed(effect, instance), access);
}

std::vector<std::size_t> application_order(const std::vector<EffectInstance>& instances) {
    const auto place = [&](std::size_t index) -> std::ptrdiff_t {
        const Effect& effect = known_effect(instances[index]);
        return effect.wrong_number ? -1 : &effect - effects().data();
    };
    std::vector<std::size_t> order(instances.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    return order;
}

void apply(const std::vector<EffectInstance>& instances, const ParameterAccess& access, pem::CaseParameters& parameters,
           bool force) {
    for (const std::size_t index : application_order(instances)) apply(instances[index], access, parameters, force);
}

}  // namespace railpem::diagnosis

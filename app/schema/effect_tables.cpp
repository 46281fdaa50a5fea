#include "app/schema/effect_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/schema/case_numbers.hpp"
#include "app/schema/effect_list.hpp"
#include "app/schema/nearest_key.hpp"
#include "app/schema/read_table.hpp"
#include "app/schema/write_table.hpp"

namespace railpem::app {

using diagnosis::EffectChoice;
using diagnosis::EffectInstance;
using namespace parameters;

namespace {

/// "effect.exponent" of instance 1 is "effect[2].exponent" of the file.
ParameterError located(const ParameterError& error, std::size_t index) {
    constexpr std::string_view kPrefix = "effect.";
    if (!error.key().starts_with(kPrefix)) return error;
    return {fmt::format("effect[{}].{}", index + 1, error.key().substr(kPrefix.size())), error.problem(),
            error.allowed()};
}

/// A key that the case does not have is refused here, where the nearest can be offered; and both ways to write the
/// element of a list become one.
void settle_keys(const Document& document, const diagnosis::ParameterAccess& access, std::size_t index,
                 EffectInstance& instance) {
    for (const EffectChoice& choice : diagnosis::find_effect(instance.effect)->choices) {
        if (!choice.options.empty()) continue;
        std::string& key = instance.choices.at(choice.name);
        const std::string stated = key;
        key = key_text(key_steps(key));
        if (std::find(access.keys.begin(), access.keys.end(), key) != access.keys.end()) continue;
        const Node& table = document.root.find("effect")->node.elements[index];
        throw document.error(table.find(choice.name)->node.place,
                             {.what = fmt::format("the case has no physical number '{}'", stated),
                              .allowed = "a dotted key of a number that the case states or has by default",
                              .hint = did_you_mean(key, access.keys)});
    }
}

}  // namespace

std::vector<EffectInstance> read_effects(const Document& document, const TableSchema& root, Refusals* all) {
    std::vector<std::unique_ptr<EffectInstance>> read;  // the reader keeps the address of one while it makes the next
    read_variants(
        document, root, effect_list(),
        [&](const std::string&) { return read.emplace_back(std::make_unique<EffectInstance>()).get(); }, all);
    std::vector<EffectInstance> effects;
    for (const auto& instance : read) effects.push_back(*instance);
    return effects;
}

pem::CaseParameters with_effects(const Document& document, pem::CaseParameters parameters,
                                 const std::vector<EffectInstance>& effects) {
    if (effects.empty()) return parameters;
    const diagnosis::ParameterAccess access = parameter_access(parameters);
    for (const std::size_t index : diagnosis::application_order(effects)) {
        EffectInstance instance = effects[index];
        settle_keys(document, access, index, instance);
        try {
            diagnosis::apply(instance, access, parameters);
        } catch (const ParameterError& error) {
            throw refused(document, located(error, index));
        }
    }
    return parameters;
}

std::string write_effects(const std::vector<EffectInstance>& effects) {
    const EffectInstance nothing;
    std::string text;
    for (const EffectInstance& instance : effects)
        text += "\n[[effect]]\n" + write_table(effect_list().variant(instance.effect), &instance, &nothing);
    return text;
}

diagnosis::ParameterAccess parameter_access(const pem::CaseParameters& parameters) {
    const auto numbers = std::make_shared<std::map<std::string, CaseNumber>>();
    diagnosis::ParameterAccess access;
    for (const CaseNumber& number : case_numbers(parameters)) {
        if (number.key.starts_with("frequency.") || number.key.starts_with("solver.")) continue;
        access.keys.push_back(number.key);
        numbers->emplace(number.key, number);
    }
    access.get = [numbers](const pem::CaseParameters& owner, const std::string& key) {
        return numbers->at(key).get(owner);
    };
    access.set = [numbers](pem::CaseParameters& owner, const std::string& key, double value) {
        const CaseNumber& number = numbers->at(key);
        if (!number.description.range.contains(value))
            throw ParameterError("effect.factor", fmt::format("'{}' would be {:g}", key, value),
                                 allowed_text(number.description));
        number.set(owner, value);
    };
    return access;
}

}  // namespace railpem::app

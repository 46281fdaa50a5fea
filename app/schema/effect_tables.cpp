#include "app/schema/effect_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "app/schema/case_schema.hpp"
#include "app/schema/nearest_key.hpp"
#include "app/schema/read_table.hpp"
#include "app/schema/write_table.hpp"

namespace railpem::app {

using diagnosis::Effect;
using diagnosis::EffectChoice;
using diagnosis::EffectInstance;
using diagnosis::EffectParameter;
using namespace parameters;

namespace {

/// What a parameter reads as when the table does not state it: no range contains it, so it is written never.
constexpr double kNotStated = std::numeric_limits<double>::lowest();

const EffectInstance& read_from(const void* owner) {
    return *static_cast<const EffectInstance*>(owner);
}

EffectInstance& write_to(void* owner) {
    return *static_cast<EffectInstance*>(owner);
}

FieldSchema id_field() {
    Description description{.key = "id", .kind = Kind::choice, .required = true, .says = "which effect"};
    for (const Effect& effect : diagnosis::effects()) description.choices.push_back(effect.id);
    return {std::move(description), [](const void* owner) { return Value(read_from(owner).effect); },
            [](void* owner, const Value& value) { write_to(owner).effect = std::get<std::string>(value); }};
}

FieldSchema parameter_field(const EffectParameter& parameter) {
    Description description{.key = parameter.name,
                            .unit = parameter.unit,
                            .kind = Kind::number,
                            .range = between(parameter.low, parameter.high),
                            .says = parameter.says};
    return {std::move(description),
            [name = parameter.name](const void* owner) {
                const auto& values = read_from(owner).values;
                const auto stated = values.find(name);
                return Value(stated == values.end() ? kNotStated : stated->second);
            },
            [name = parameter.name](void* owner, const Value& value) {
                write_to(owner).values[name] = std::get<double>(value);
            }};
}

std::string stated_choice(const void* owner, const std::string& name) {
    const auto& choices = read_from(owner).choices;
    const auto stated = choices.find(name);
    return stated == choices.end() ? "" : stated->second;
}

FieldSchema choice_field(const EffectChoice& choice) {
    Description description{.key = choice.name, .kind = Kind::text, .required = choice.required, .says = choice.says};
    const std::string name = choice.name;
    if (choice.whole_number) {
        description.kind = Kind::integer;
        description.unit = "1";
        description.range = between(std::stod(choice.options.front()), std::stod(choice.options.back()));
        return {std::move(description),
                [name](const void* owner) {
                    const std::string stated = stated_choice(owner, name);
                    return Value(stated.empty() ? std::int64_t{0} : std::int64_t{std::stoll(stated)});
                },
                [name](void* owner, const Value& value) {
                    write_to(owner).choices[name] = fmt::format("{}", std::get<std::int64_t>(value));
                }};
    }
    if (!choice.options.empty()) {
        description.kind = Kind::choice;
        description.choices = choice.options;
    }
    return {std::move(description), [name](const void* owner) { return Value(stated_choice(owner, name)); },
            [name](void* owner, const Value& value) { write_to(owner).choices[name] = std::get<std::string>(value); }};
}

VariantListSchema make_effect_list() {
    VariantListSchema list{.name = "effect",
                           .says =
                               "Physics of the effect library, added to the rest of the file: `id` and the parameters "
                               "of that effect, those not stated at their typical value. [effects.md](effects.md) "
                               "lists them; the order of the tables does not matter",
                           .key = "id"};
    for (const Effect& effect : diagnosis::effects()) {
        const auto table = std::make_shared<TableSchema>();
        table->fields.push_back(id_field());
        for (const EffectChoice& choice : effect.choices) table->fields.push_back(choice_field(choice));
        for (const EffectParameter& parameter : effect.parameters) table->fields.push_back(parameter_field(parameter));
        list.variants[effect.id] = table;
    }
    const auto unknown = std::make_shared<TableSchema>();
    unknown->fields.push_back(id_field());
    list.unknown = unknown;
    return list;
}

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

const VariantListSchema& effect_list() {
    static const VariantListSchema list = make_effect_list();
    return list;
}

std::vector<EffectInstance> read_effects(const Document& document, const TableSchema& root) {
    std::vector<std::unique_ptr<EffectInstance>> read;  // the reader keeps the address of one while it makes the next
    read_variants(document, root, effect_list(),
                  [&](const std::string&) { return read.emplace_back(std::make_unique<EffectInstance>()).get(); });
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

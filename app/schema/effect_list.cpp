#include "app/schema/effect_list.hpp"

#include <fmt/format.h>

#include <limits>
#include <memory>

#include "diagnosis/effects/effect.hpp"

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

}  // namespace

const VariantListSchema& effect_list() {
    static const VariantListSchema list = make_effect_list();
    return list;
}

}  // namespace railpem::app

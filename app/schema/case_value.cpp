#include "app/schema/case_value.hpp"

#include <fmt/format.h>

#include "app/schema/nearest_key.hpp"
#include "app/schema/read_table.hpp"

namespace railpem::app {

namespace {

/// A table of the schema together with the struct that it describes. Schemas reach children through mutable pointers;
/// nothing here writes.
struct Bound {
    const TableSchema* schema;
    void* owner;
};

/// Where a step leads; a schema of nullptr says nowhere.
Bound descend(const Bound& from, const Step& step) {
    if (const SubtableSchema* child = from.schema->table(step.name); child && step.element == 0)
        return {child->table.get(), child->member(from.owner)};
    const TableListSchema* list = from.schema->list(step.name);
    if (!list) return {nullptr, nullptr};
    const std::size_t size = list->size(from.owner), index = step.element == 0 ? 0 : step.element - 1;
    if (index >= size || (step.element == 0 && size > 1)) return {nullptr, nullptr};
    return {list->table.get(), list->at(from.owner, index)};
}

void collect_keys(const Bound& table, const std::string& path, std::vector<std::string>& keys) {
    for (const FieldSchema& field : table.schema->fields) keys.push_back(inner_key(path, field.description.key));
    for (const SubtableSchema& child : table.schema->tables)
        collect_keys({child.table.get(), child.member(table.owner)}, inner_key(path, child.name), keys);
    for (const TableListSchema& list : table.schema->lists)
        for (std::size_t i = 0; i < list.size(table.owner); ++i)
            collect_keys({list.table.get(), list.at(table.owner, i)},
                         inner_key(path, fmt::format("{}[{}]", list.name, i + 1)), keys);
    for (const KeyedNumbersSchema& keyed : table.schema->keyed_numbers)
        for (const auto& [key, value] : keyed.member(table.owner))
            keys.push_back(inner_key(inner_key(path, keyed.name), key));
}

Bound top_of(const CaseFile& file) {
    return {&case_schema(), const_cast<pem::CaseParameters*>(&file.without_effects)};
}

}  // namespace

std::optional<parameters::Value> case_value(const CaseFile& file, const std::string& key) {
    const std::vector<Step> steps = key_steps(key);
    Bound table = top_of(file);
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        if (const KeyedNumbersSchema* keyed = table.schema->keyed(steps[i].name)) {
            const auto& numbers = keyed->member(table.owner);
            const auto found =
                numbers.find(key_text({steps.begin() + static_cast<std::ptrdiff_t>(i + 1), steps.end()}));
            return found == numbers.end() ? std::nullopt : std::optional<parameters::Value>(found->second);
        }
        table = descend(table, steps[i]);
        if (!table.schema) return std::nullopt;
    }
    const FieldSchema* field = steps.back().element == 0 ? table.schema->field(steps.back().name) : nullptr;
    return field ? std::optional(field->get(table.owner)) : std::nullopt;
}

std::vector<std::string> case_keys(const CaseFile& file) {
    std::vector<std::string> keys;
    collect_keys(top_of(file), "", keys);
    return keys;
}

InputError unknown_case_key(const CaseFile& file, const std::string& key) {
    return input_error(file.document.name, "", {},
                       {.what = fmt::format("the case has no key '{}'", key),
                        .allowed = "a dotted key; railpem describe case lists them",
                        .hint = did_you_mean(key, case_keys(file))});
}

}  // namespace railpem::app

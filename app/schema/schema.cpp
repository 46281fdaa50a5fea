#include "app/schema/schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "app/schema/nearest_key.hpp"

namespace railpem::app {

using namespace parameters;

namespace {

template <class Item, class Name>
const Item* find_named(const std::vector<Item>& items, const std::string& wanted, Name name) {
    for (const Item& item : items)
        if (name(item) == wanted) return &item;
    return nullptr;
}

const auto kName = [](const auto& item) -> const std::string& { return item.name; };

/// The whole number that a text is, or 0.
std::size_t element_number(const std::string& text) {
    std::size_t number = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    return status == std::errc() && end == text.data() + text.size() ? number : 0;
}

/// Dotted keys of all fields below a table for which `wanted` holds.
template <class Wanted>
void collect_keys(const TableSchema& schema, const std::string& prefix, const Wanted& wanted,
                  std::vector<std::string>& keys) {
    for (const FieldSchema& field : schema.fields)
        if (wanted(field.description)) keys.push_back(prefix + field.description.key);
    for (const SubtableSchema& child : schema.tables)
        collect_keys(*child.table, prefix + child.name + ".", wanted, keys);
    for (const TableListSchema& child : schema.lists)
        collect_keys(*child.table, prefix + child.name + ".", wanted, keys);
}

bool is_number(const Description& description) {
    return description.kind == Kind::number || description.kind == Kind::numbers;
}

}  // namespace

const FieldSchema* TableSchema::field(const std::string& key) const {
    return find_named(fields, key, [](const FieldSchema& item) -> const std::string& { return item.description.key; });
}
const SubtableSchema* TableSchema::table(const std::string& name) const {
    return find_named(tables, name, kName);
}
const TableListSchema* TableSchema::list(const std::string& name) const {
    return find_named(lists, name, kName);
}
const KeyedNumbersSchema* TableSchema::keyed(const std::string& name) const {
    return find_named(keyed_numbers, name, kName);
}

const VariantListSchema* TableSchema::variant_list(const std::string& name) const {
    return find_named(variant_lists, name, kName);
}

const TableSchema& VariantListSchema::variant(const std::string& kind) const {
    const auto found = variants.find(kind);
    return found == variants.end() ? *unknown : *found->second;
}

std::vector<std::string> TableSchema::names() const {
    std::vector<std::string> all;
    for (const FieldSchema& item : fields) all.push_back(item.description.key);
    for (const SubtableSchema& item : tables) all.push_back(item.name);
    for (const TableListSchema& item : lists) all.push_back(item.name);
    for (const KeyedNumbersSchema& item : keyed_numbers) all.push_back(item.name);
    for (const VariantListSchema& item : variant_lists) all.push_back(item.name);
    return all;
}

std::string allowed_text(const Description& description) {
    const std::string unit = description.unit.empty() || description.unit == "1" ? "" : ", in " + description.unit;
    const std::string range = description.range.text();
    const bool any = range == any_number().text();
    switch (description.kind) {
        case Kind::boolean:
            return "true or false";
        case Kind::text:
            return "a text in quotes";
        case Kind::choice:
            return fmt::format("\"{}\"", fmt::join(description.choices, "\", \""));
        case Kind::integer:
            return any ? "an integer" : "an integer " + range;
        case Kind::number:
            return (any ? range : "a number " + range) + unit;
        case Kind::numbers:
            return (any ? "numbers" : "numbers " + range) + unit + " (one, or a list)";
    }
    return "";
}

std::vector<Step> key_steps(const std::string& key) {
    std::vector<Step> steps;
    for (std::size_t begin = 0; begin <= key.size();) {
        const std::size_t end = std::min(key.find('.', begin), key.size());
        std::string name = key.substr(begin, end - begin);
        begin = end + 1;
        if (const std::size_t number = element_number(name);
            number > 0 && !steps.empty() && steps.back().element == 0) {
            steps.back().element = number;
            continue;
        }
        const std::size_t bracket = name.find('[');
        std::size_t element = 0;
        if (bracket != std::string::npos && name.back() == ']') {
            element = element_number(name.substr(bracket + 1, name.size() - bracket - 2));
            if (element > 0) name.resize(bracket);
        }
        steps.push_back({name, element});
    }
    return steps;
}

std::string key_text(const std::vector<Step>& steps) {
    std::string text;
    for (const Step& step : steps) {
        if (!text.empty()) text += '.';
        text += step.name;
        if (step.element > 0) text += fmt::format("[{}]", step.element);
    }
    return text;
}

const FieldSchema* find_field(const TableSchema& schema, const std::vector<Step>& steps) {
    const TableSchema* table = &schema;
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        if (const SubtableSchema* child = table->table(steps[i].name); child && steps[i].element == 0)
            table = child->table.get();
        else if (const TableListSchema* list = table->list(steps[i].name))
            table = list->table.get();
        else
            return nullptr;
    }
    return steps.empty() || steps.back().element > 0 ? nullptr : table->field(steps.back().name);
}

std::vector<std::string> number_keys(const TableSchema& schema) {
    std::vector<std::string> keys;
    collect_keys(schema, "", is_number, keys);
    return keys;
}

std::vector<std::string> keys_named(const TableSchema& schema, const std::string& name) {
    std::vector<std::string> keys;
    collect_keys(
        schema, "", [&](const Description& description) { return description.key == name; }, keys);
    return keys;
}

std::string did_you_mean(const std::string& unknown, const TableSchema& table, const TableSchema& root) {
    const std::string near = nearest_key(unknown, table.names());
    if (!near.empty()) {
        const FieldSchema* field = table.field(near);
        const bool other_unit = field && near != unknown && without_unit(near) == without_unit(unknown);
        return other_unit ? fmt::format("did you mean '{}', in {}?", near, field->description.unit)
                          : fmt::format("did you mean '{}'?", near);
    }
    const std::vector<std::string> elsewhere = keys_named(root, unknown);
    return elsewhere.empty() ? table.note : fmt::format("did you mean '{}'?", fmt::join(elsewhere, "' or '"));
}

}  // namespace railpem::app

#include "app/schema/apply_option.hpp"

#include <fmt/format.h>

#include "app/key_depth.hpp"
#include "app/schema/read_table.hpp"

namespace railpem::app {

namespace {

/// Descends one step of an option's key, making the tables that are not there yet.
struct OptionTarget {
    Node* node;
    const TableSchema* schema;
};

Node& child_node(Node& table, const std::string& name, NodeKind kind, const Place& place) {
    if (Entry* entry = table.find(name)) return entry->node;
    Node made;
    made.kind = kind;
    made.place = place;
    table.entries.push_back({name, place, std::move(made)});
    return table.entries.back().node;
}

Node& list_element(Document& document, Node& list, const Step& step, const Place& place) {
    const std::size_t count = list.elements.size();
    if (step.element == 0 && count > 1)
        throw document.error(place, {.what = fmt::format("there are {} '{}'", count, step.name),
                                     .allowed = fmt::format("one of {0}[1] to {0}[{1}], or {0}[{2}] for a new one",
                                                            step.name, count, count + 1)});
    const std::size_t index = step.element == 0 ? 0 : step.element - 1;
    if (index > count)
        throw document.error(place, {.what = fmt::format("there is no {}[{}]", step.name, step.element),
                                     .allowed = fmt::format("{0}[1] to {0}[{1}]", step.name, count + 1)});
    if (index == count) {
        Node made;
        made.place = place;
        list.elements.push_back(std::move(made));
    }
    return list.elements[index];
}

/// Where a step leads; a schema of nullptr says that the rest of the key is free (keyed numbers).
OptionTarget descend(Document& document, const TableSchema& root, OptionTarget from, const Step& step,
                     const std::string& path, const Place& place) {
    Node& table = *from.node;
    if (table.kind != NodeKind::table)
        throw document.error(place, {.what = fmt::format("{} is not a table in the file", table_text(path))});
    if (const SubtableSchema* child = from.schema->table(step.name); child && step.element == 0)
        return {&child_node(table, step.name, NodeKind::table, place), child->table.get()};
    if (const TableListSchema* list = from.schema->list(step.name)) {
        Node& elements = child_node(table, step.name, NodeKind::array, place);
        if (elements.kind != NodeKind::array)
            throw document.error(place, {.what = fmt::format("'{}' is not a list of tables in the file", step.name)});
        return {&list_element(document, elements, step, place), list->table.get()};
    }
    if (const VariantListSchema* list = from.schema->variant_list(step.name)) {
        Node& elements = child_node(table, step.name, NodeKind::array, place);
        if (elements.kind != NodeKind::array)
            throw document.error(place, {.what = fmt::format("'{}' is not a list of tables in the file", step.name)});
        Node& element = list_element(document, elements, step, place);
        const Entry* kind = element.find(list->key);
        return {&element, &list->variant(kind ? kind->node.text : "")};
    }
    if (from.schema->keyed(step.name)) return {&child_node(table, step.name, NodeKind::table, place), nullptr};
    Entry unknown{.key = step.name, .place = place, .node = {}};
    unknown.node.kind = NodeKind::table;
    throw document.error(place, unknown_key(unknown, *from.schema, path, root));
}

/// A number of [tolerance] may stand there as a quoted dotted key or nested: both give way to the option.
void remove_keyed(Node& table, const std::string& prefix, const std::string& key) {
    std::erase_if(table.entries, [&](const Entry& entry) {
        return entry.node.kind != NodeKind::table && key_text(key_steps(inner_key(prefix, entry.key))) == key;
    });
    for (Entry& entry : table.entries)
        if (entry.node.kind == NodeKind::table) remove_keyed(entry.node, inner_key(prefix, entry.key), key);
}

}  // namespace

void apply_option(Document& document, const TableSchema& schema, const std::string& key_and_value) {
    const Place place{.option = "--set " + key_and_value};
    const std::size_t equals = key_and_value.find('=');
    if (equals == std::string::npos || equals == 0)
        throw document.error(
            place, {.what = "no key and value", .allowed = "--set key=value, such as --set vehicle.payload_kg=5000"});
    const std::vector<Step> steps = key_steps(key_and_value.substr(0, equals));
    if (steps.size() > kDeepestKey)
        throw document.error({.option = "--set"}, {.what = fmt::format("a key of {} names", steps.size()),
                                                   .allowed = fmt::format("at most {} names", kDeepestKey)});
    Node value = parse_option_value(key_and_value.substr(equals + 1), place);

    OptionTarget target{&document.root, &schema};
    std::string path;
    std::size_t i = 0;
    for (; i + 1 < steps.size() && target.schema; ++i) {
        target = descend(document, schema, target, steps[i], path, place);
        path = inner_key(path, steps[i].name);
    }
    std::string key = steps.back().name;
    if (!target.schema) {
        key = key_text({steps.begin() + static_cast<std::ptrdiff_t>(i), steps.end()});
        remove_keyed(*target.node, "", key);
    } else if (!target.schema->field(key) || steps.back().element > 0) {
        throw document.error(place, unknown_key({.key = key_text({steps.back()}), .place = place, .node = value},
                                                *target.schema, path, schema));
    }
    if (Entry* entry = target.node->find(key))
        *entry = {key, place, std::move(value)};
    else
        target.node->entries.push_back({key, place, std::move(value)});
}

}  // namespace railpem::app

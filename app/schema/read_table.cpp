#include "app/schema/read_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/schema/nearest_key.hpp"

namespace railpem::app {

using namespace parameters;

std::string table_text(const std::string& path) {
    return path.empty() ? "the file" : "[" + path + "]";
}

std::string inner_key(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + "." + name;
}

Problem unknown_key(const Entry& entry, const TableSchema& table, const std::string& path, const TableSchema& root) {
    const bool is_table = entry.node.kind == NodeKind::table;
    return {.what = is_table ? fmt::format("unknown table [{}]", inner_key(path, entry.key))
                             : fmt::format("unknown key '{}' in {}", entry.key, table_text(path)),
            .allowed = joined(table.names()),
            .hint = did_you_mean(entry.key, table, root)};
}

namespace {

bool contains(const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// What stays the same while a file is read.
struct Reading {
    const Document& document;
    const TableSchema& root;
    Refusals* all = nullptr;
};

[[noreturn]] void refuse(const Reading& reading, const Place& place, const Problem& problem) {
    throw reading.document.error(place, problem);
}

[[noreturn]] void refuse_kind(const Reading& reading, const Entry& entry, const Description& description) {
    refuse(reading, entry.node.place,
           {.what = fmt::format("'{}' cannot be {}", entry.key, kind_text(entry.node.kind)),
            .allowed = allowed_text(description)});
}

/// A number in its range, or the end of the reading.
double checked_number(const Reading& reading, const Entry& entry, const Node& node, const Description& description) {
    if (node.kind != NodeKind::number && node.kind != NodeKind::integer) {
        if (node.kind == entry.node.kind) refuse_kind(reading, entry, description);
        refuse(reading, node.place,
               {.what = fmt::format("'{}' cannot hold {}", entry.key, kind_text(node.kind)),
                .allowed = allowed_text(description)});
    }
    const double value = node.kind == NodeKind::integer ? static_cast<double>(node.integer) : node.number;
    if (!description.range.contains(value))
        refuse(reading, node.place,
               {.what = fmt::format("'{}' cannot be {:g}", entry.key, value), .allowed = allowed_text(description)});
    return value;
}

Value read_value(const Reading& reading, const Entry& entry, const Description& description) {
    const Node& node = entry.node;
    switch (description.kind) {
        case Kind::boolean:
            if (node.kind != NodeKind::boolean) refuse_kind(reading, entry, description);
            return node.boolean;
        case Kind::integer:
            if (node.kind != NodeKind::integer) refuse_kind(reading, entry, description);
            checked_number(reading, entry, node, description);
            return node.integer;
        case Kind::number:
            return checked_number(reading, entry, node, description);
        case Kind::text:
            if (node.kind != NodeKind::text) refuse_kind(reading, entry, description);
            return node.text;
        case Kind::choice: {
            if (node.kind != NodeKind::text) refuse_kind(reading, entry, description);
            for (const std::string& choice : description.choices)
                if (choice == node.text) return node.text;
            const std::string near = nearest_key(node.text, description.choices);
            refuse(reading, node.place,
                   {.what = fmt::format("'{}' cannot be \"{}\"", entry.key, node.text),
                    .allowed = allowed_text(description),
                    .hint = near.empty() ? "" : fmt::format("did you mean \"{}\"?", near)});
        }
        case Kind::numbers: {
            std::vector<double> values;
            if (node.kind != NodeKind::array) values.push_back(checked_number(reading, entry, node, description));
            for (const Node& element : node.elements)
                values.push_back(checked_number(reading, entry, element, description));
            return values;
        }
    }
    return {};
}

/// [tolerance]: nested tables or quoted dotted keys, each naming a number of the file.
void read_keyed_numbers(const Reading& reading, const Node& node, const KeyedNumbersSchema& schema,
                        const std::string& prefix, std::map<std::string, double>& values) {
    for (const Entry& entry : node.entries) {
        const std::string key = inner_key(prefix, entry.key);
        if (entry.node.kind == NodeKind::table) {
            read_keyed_numbers(reading, entry.node, schema, key, values);
            continue;
        }
        const FieldSchema* field = find_field(reading.root, key_steps(key));
        if (!field || (field->description.kind != Kind::number && field->description.kind != Kind::numbers)) {
            refuse(reading, entry.place,
                   {.what = fmt::format("[{}] names '{}', which is not a number of this file", schema.name, key),
                    .allowed = "the dotted key of a number, such as " + number_keys(reading.root).front(),
                    .hint = did_you_mean(key, number_keys(reading.root))});
        }
        Description description = field->description;
        description.kind = Kind::number;
        description.unit.clear();
        description.range = schema.range;
        values[key_text(key_steps(key))] = checked_number(reading, entry, entry.node, description);
    }
}

/// One table of the file into the struct of its schema.
struct TableReader {
    const Reading& reading;
    const TableSchema& schema;
    const std::string path;
    void* owner;

    void read(const Node& node) const {
        for (const Entry& entry : node.entries) guarded(reading.all, [&] { read_entry(entry); });
        require(node);
    }

    void read_entry(const Entry& entry) const {
        if (const FieldSchema* field = schema.field(entry.key))
            field->set(owner, read_value(reading, entry, field->description));
        else if (const SubtableSchema* child = schema.table(entry.key))
            read_subtable(entry, *child);
        else if (const TableListSchema* list = schema.list(entry.key))
            read_list(entry, *list);
        else if (const KeyedNumbersSchema* keyed = schema.keyed(entry.key))
            read_keyed(entry, *keyed);
        else if (const VariantListSchema* variants = schema.variant_list(entry.key))
            refuse_unless_list(entry, inner_key(path, variants->name));
        else
            refuse(reading, entry.place, unknown_key(entry, schema, path, reading.root));
    }

    void read_subtable(const Entry& entry, const SubtableSchema& child) const {
        refuse_unless_table(entry);
        TableReader{reading, *child.table, inner_key(path, child.name), child.member(owner)}.read(entry.node);
    }

    void refuse_unless_table(const Entry& entry) const {
        if (entry.node.kind == NodeKind::table) return;
        const std::string header = "[" + inner_key(path, entry.key) + "]";
        if (entry.node.kind == NodeKind::array && !entry.node.elements.empty() &&
            entry.node.elements.front().kind == NodeKind::table)
            refuse(
                reading, entry.place,
                {.what = fmt::format("{} stands only once", header), .allowed = fmt::format("one table {}", header)});
        refuse(reading, entry.node.place,
               {.what = fmt::format("'{}' is a table, not {}", entry.key, kind_text(entry.node.kind)),
                .allowed = fmt::format("one table {}", header)});
    }

    void read_list(const Entry& entry, const TableListSchema& list) const {
        const std::string name = inner_key(path, list.name);
        refuse_unless_list(entry, name);
        for (const Node& element : entry.node.elements)
            TableReader{reading, *list.table, name, list.append(owner)}.read(element);
    }

    void refuse_unless_list(const Entry& entry, const std::string& name) const {
        const std::string allowed = fmt::format("tables [[{}]], as many as there are", name);
        if (entry.node.kind != NodeKind::array)
            refuse(reading, entry.place,
                   {.what = fmt::format("'{}' is a list of tables, not {}", entry.key, kind_text(entry.node.kind)),
                    .allowed = allowed});
        for (const Node& element : entry.node.elements) {
            if (element.kind != NodeKind::table)
                refuse(reading, element.place,
                       {.what = fmt::format("'{}' is a list of tables, it cannot hold {}", entry.key,
                                            kind_text(element.kind)),
                        .allowed = allowed});
        }
    }

    void read_keyed(const Entry& entry, const KeyedNumbersSchema& keyed) const {
        refuse_unless_table(entry);
        read_keyed_numbers(reading, entry.node, keyed, "", keyed.member(owner));
    }

    /// Required keys, and the tables that hold some.
    void require(const Node& node) const {
        for (const FieldSchema& field : schema.fields) {
            const Description& description = field.description;
            if (!description.required || node.find(description.key)) continue;
            guarded(reading.all, [&] {
                refuse(reading, node.place,
                       {.what = fmt::format("{} has no '{}' ({})", table_text(path), description.key, description.says),
                        .allowed = allowed_text(description),
                        .hint = contains(schema.note_keys, description.key) ? schema.note : ""});
            });
        }
        for (const SubtableSchema& child : schema.tables) {
            if (node.find(child.name)) continue;
            TableReader missing{reading, *child.table, inner_key(path, child.name), child.member(owner)};
            Node nothing;
            nothing.place = node.place;
            missing.require(nothing);
        }
    }
};

}  // namespace

void read_table(const Document& document, const TableSchema& schema, void* owner, Refusals* all) {
    const Reading reading{document, schema, all};
    TableReader{reading, schema, "", owner}.read(document.root);
}

void read_variants(const Document& document, const TableSchema& root, const VariantListSchema& list,
                   const std::function<void*(const std::string& kind)>& append, Refusals* all) {
    const Reading reading{document, root, all};
    const Entry* entry = document.root.find(list.name);
    if (!entry) return;
    const auto read_element = [&](const Node& element) {
        const FieldSchema& key = *list.unknown->field(list.key);
        const Entry* kind = element.find(list.key);
        if (!kind)
            refuse(reading, element.place,
                   {.what = fmt::format("{} has no '{}' ({})", table_text(list.name), list.key, key.description.says),
                    .allowed = allowed_text(key.description)});
        const std::string name = std::get<std::string>(read_value(reading, *kind, key.description));
        TableReader{reading, list.variant(name), list.name, append(name)}.read(element);
    };
    for (const Node& element : entry->node.elements) guarded(all, [&] { read_element(element); });
}

Place place_of(const Document& document, const std::string& key) {
    const Node* node = &document.root;
    Place place = node->place;
    for (const Step& step : key_steps(key)) {
        const Entry* entry = node->kind == NodeKind::table ? node->find(step.name) : nullptr;
        if (!entry) break;
        node = &entry->node;
        if (node->kind == NodeKind::array && !node->elements.empty() &&
            node->elements.front().kind == NodeKind::table) {
            if (step.element > node->elements.size()) break;
            node = &node->elements[step.element > 0 ? step.element - 1 : 0];
        }
        place = node->place;
    }
    return place;
}

InputError refused(const Document& document, const ParameterError& error) {
    return document.error(place_of(document, error.key()),
                          {.what = fmt::format("{}: {}", error.key(), error.problem()), .allowed = error.allowed()});
}

}  // namespace railpem::app

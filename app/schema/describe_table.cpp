#include "app/schema/describe_table.hpp"

#include <fmt/format.h>

#include "app/schema/read_table.hpp"

namespace railpem::app {

using namespace parameters;

namespace {

std::string default_text(const FieldSchema& field, const void* defaults) {
    if (field.description.required) return "**required**";
    const Value value = field.get(defaults);
    if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "`true`" : "`false`";
    if (const std::int64_t* number = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *number);
    if (const double* number = std::get_if<double>(&value)) return fmt::format("{:g}", *number);
    if (const std::string* text = std::get_if<std::string>(&value))
        return text->empty() ? "–" : fmt::format("`\"{}\"`", *text);
    return std::get<std::vector<double>>(value).empty() ? "–" : "a list";
}

std::string type_text(const Description& description) {
    switch (description.kind) {
        case Kind::boolean:
            return "true or false";
        case Kind::integer:
            return "integer";
        case Kind::number:
            return "number";
        case Kind::numbers:
            return "number or list";
        case Kind::choice:
            return "choice";
        case Kind::text:
            return "text";
    }
    return "";
}

std::string range_text(const Description& description) {
    if (description.kind == Kind::choice) return allowed_text(description);
    if (description.kind == Kind::boolean || description.kind == Kind::text) return "";
    return description.range.text();
}

/// Text for a cell_text of a Markdown table.
std::string cell_text(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return text;
}

void describe_fields(const TableSchema& schema, const void* defaults, std::string& page) {
    if (schema.fields.empty()) return;
    page +=
        "| key | unit | type | default | allowed | tolerance | what it is | source "
        "|\n|---|---|---|---|---|---|---|---|\n";
    for (const FieldSchema& field : schema.fields) {
        const Description& description = field.description;
        const std::string tolerance =
            description.tolerance > 0.0 ? fmt::format("{:g} %", 100.0 * description.tolerance) : "";
        page += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} |\n", description.key, description.unit,
                            type_text(description), default_text(field, defaults), cell_text(range_text(description)),
                            tolerance, cell_text(description.says), cell_text(description.source));
    }
    page += "\n";
}

void describe(const TableSchema& schema, const void* defaults, const std::string& path, std::string& page) {
    describe_fields(schema, defaults, page);
    for (const SubtableSchema& child : schema.tables) {
        const std::string name = inner_key(path, child.name);
        page += fmt::format("## `[{}]`\n\n{}.\n\n", name, child.says);
        describe(*child.table, child.member(const_cast<void*>(defaults)), name, page);
    }
    for (const TableListSchema& list : schema.lists) {
        const std::string name = inner_key(path, list.name);
        page += fmt::format("## `[[{}]]`\n\n{}.\n\n", name, list.says);
        describe(*list.table, list.example.get(), name, page);
    }
    for (const VariantListSchema& list : schema.variant_lists)
        page += fmt::format("## `[[{}]]`\n\n{}.\n\n", inner_key(path, list.name), list.says);
    for (const KeyedNumbersSchema& keyed : schema.keyed_numbers)
        page += fmt::format("## `[{}]`\n\n{}. Values: numbers {}.\n\n", inner_key(path, keyed.name), keyed.says,
                            keyed.range.text());
}

}  // namespace

std::string describe_table(const std::string& title, const std::string& introduction, const TableSchema& schema,
                           const void* defaults) {
    std::string page = fmt::format("# {}\n\n{}\n\n", title, introduction);
    describe(schema, defaults, "", page);
    page.pop_back();
    return page;
}

}  // namespace railpem::app

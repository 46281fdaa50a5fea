#include "app/schema/write_table.hpp"

#include <fmt/format.h>

#include "app/schema/read_table.hpp"

namespace railpem::app {

using namespace parameters;

namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            result += std::string{'\\', c};
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
            result += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        else
            result += c;
    }
    return result + '"';
}

std::string list_text(const std::vector<double>& values) {
    if (values.size() == 1) return fmt::format("{}", values.front());
    std::string text = "[";
    for (std::size_t i = 0; i < values.size(); ++i)
        text += fmt::format("{}{}", i == 0 ? "" : i % 8 == 0 ? ",\n  " : ", ", values[i]);
    return text + "]";
}

struct ValueText {
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
    std::string operator()(double value) const { return fmt::format("{}", value); }
    std::string operator()(const std::string& value) const { return quoted(value); }
    std::string operator()(const std::vector<double>& value) const { return list_text(value); }
};

/// A table under its header; nothing when it has nothing to say, unless it is an element of a list.
struct TableWriter {
    std::string& text;

    void table(const TableSchema& schema, const void* owner, const void* defaults, const std::string& path,
               const std::string& header, bool always) {
        std::string lines;
        for (const FieldSchema& field : schema.fields) {
            const Value value = field.get(owner);
            if (!field.description.required && value == field.get(defaults)) continue;
            lines += fmt::format("{} = {}\n", field.description.key, std::visit(ValueText{}, value));
        }
        if (!lines.empty() || always)
            text += (text.empty() ? "" : "\n") + (header.empty() ? "" : header + "\n") + lines;
        for (const SubtableSchema& child : schema.tables) {
            const std::string name = inner_key(path, child.name);
            table(*child.table, member(child, owner), member(child, defaults), name, "[" + name + "]", false);
        }
        for (const TableListSchema& list : schema.lists) {
            const std::string name = inner_key(path, list.name);
            for (std::size_t i = 0; i < list.size(owner); ++i)
                table(*list.table, list.at(const_cast<void*>(owner), i), list.example.get(), name, "[[" + name + "]]",
                      true);
        }
        for (const KeyedNumbersSchema& keyed : schema.keyed_numbers) numbers(keyed, owner, inner_key(path, keyed.name));
    }

    void numbers(const KeyedNumbersSchema& keyed, const void* owner, const std::string& name) {
        const std::map<std::string, double>& values = keyed.member(const_cast<void*>(owner));
        if (values.empty()) return;
        text += fmt::format("\n[{}]\n", name);
        for (const auto& [key, value] : values) text += fmt::format("{} = {}\n", quoted(key), value);
    }

    /// Schemas hand out members of what is written to; here they are only read.
    static const void* member(const SubtableSchema& child, const void* owner) {
        return child.member(const_cast<void*>(owner));
    }
};

}  // namespace

std::string write_table(const TableSchema& schema, const void* owner, const void* defaults) {
    std::string text;
    TableWriter{text}.table(schema, owner, defaults, "", "", false);
    return text;
}

}  // namespace railpem::app

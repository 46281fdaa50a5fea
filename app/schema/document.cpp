#include "app/schema/document.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

// toml++ 3.3 asserts that a key begins with a letter where a broken file has something else, and says "unreachable" of
// the letters from U+00A1 to U+0499 outside of a text, where its own tables mean "no white space". It reports an error
// right after either; as they stand, they would end a debug build, and an optimiser may take them for true.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/impl/forward_declarations.h>
#undef TOML_UNREACHABLE
#define TOML_UNREACHABLE return false
#include <toml++/impl/unicode.h>
#undef TOML_UNREACHABLE
#define TOML_UNREACHABLE __builtin_unreachable()
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "app/key_depth.hpp"
#include "app/run_inputs.hpp"
#include "recordings/files/visible_text.hpp"

namespace railpem::app {

Entry* Node::find(const std::string& key) {
    for (Entry& entry : entries)
        if (entry.key == key) return &entry;
    return nullptr;
}

const Entry* Node::find(const std::string& key) const {
    return const_cast<Node*>(this)->find(key);
}

std::string kind_text(NodeKind kind) {
    switch (kind) {
        case NodeKind::boolean:
            return "true or false";
        case NodeKind::integer:
            return "an integer";
        case NodeKind::number:
            return "a number";
        case NodeKind::text:
            return "a text";
        case NodeKind::date:
            return "a date or time";
        case NodeKind::array:
            return "a list";
        case NodeKind::table:
            return "a table";
    }
    return "";
}

InputError Document::error(const Place& place, const Problem& problem) const {
    const bool known = place.line >= 1 && place.line <= lines.size();
    return input_error(name, known ? lines[place.line - 1] : "", place, problem);
}

namespace {

Place place_of(const toml::source_region& region) {
    Place place{.line = region.begin.line, .column = region.begin.column};
    const bool one_line = region.end.line == region.begin.line && region.end.column > region.begin.column;
    // A value that goes on over several lines is marked at its beginning.
    place.length = one_line ? region.end.column - region.begin.column : 1;
    return place;
}

Node convert(const toml::node& value);

/// Entries in the order of the document: the library keeps them sorted by name.
std::vector<Entry> convert_entries(const toml::table& table) {
    std::vector<Entry> entries;
    for (const auto& [key, value] : table)
        entries.push_back({recordings::visible(key.str()), place_of(key.source()), convert(value)});
    const auto stands_before = [](const Entry& a, const Entry& b) {
        return a.place.line != b.place.line ? a.place.line < b.place.line : a.place.column < b.place.column;
    };
    std::stable_sort(entries.begin(), entries.end(), stands_before);
    return entries;
}

Node convert(const toml::node& value) {
    Node node;
    node.place = place_of(value.source());
    switch (value.type()) {
        case toml::node_type::boolean:
            node.kind = NodeKind::boolean;
            node.boolean = value.as_boolean()->get();
            break;
        case toml::node_type::integer:
            node.kind = NodeKind::integer;
            node.integer = value.as_integer()->get();
            break;
        case toml::node_type::floating_point:
            node.kind = NodeKind::number;
            node.number = value.as_floating_point()->get();
            break;
        case toml::node_type::string:
            node.kind = NodeKind::text;
            node.text = recordings::visible(value.as_string()->get());
            break;
        case toml::node_type::array:
            node.kind = NodeKind::array;
            for (const toml::node& element : *value.as_array()) node.elements.push_back(convert(element));
            break;
        case toml::node_type::table:
            node.kind = NodeKind::table;
            node.entries = convert_entries(*value.as_table());
            break;
        default:
            node.kind = NodeKind::date;
            break;
    }
    return node;
}

std::vector<std::string> split_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        if (!lines.back().empty() && lines.back().back() == '\r') lines.back().pop_back();
        begin = end + 1;
    }
    return lines;
}

[[noreturn]] void refuse_file(const std::string& path, const std::string& what, const std::string& allowed) {
    throw input_error(path, "", {}, {.what = what, .allowed = allowed});
}

[[noreturn]] void refuse_unreadable(const std::string& path) {
    refuse_file(path, fmt::format("cannot be read: {}", std::strerror(errno)), "a TOML file that can be read");
}

/// A file descriptor that closes itself.
struct OpenFile {
    int descriptor;
    explicit OpenFile(int opened) : descriptor(opened) {}
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        if (descriptor >= 0) ::close(descriptor);
    }
};

std::string read_text(const std::string& path) {
    const OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.descriptor < 0) refuse_unreadable(path);
    struct stat status {};
    if (::fstat(file.descriptor, &status) != 0) refuse_unreadable(path);
    if (S_ISDIR(status.st_mode)) refuse_file(path, "is a folder", "a TOML file");
    // The size is checked on what arrives, too: a pipe or a device states none.
    std::string text(
        std::min<std::size_t>(static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)), kLargestFile) + 1, '\0');
    std::size_t filled = 0;
    for (;;) {
        const ssize_t arrived = ::read(file.descriptor, text.data() + filled, text.size() - filled);
        if (arrived < 0 && errno == EINTR) continue;
        if (arrived < 0) refuse_unreadable(path);
        if (arrived == 0) break;
        filled += static_cast<std::size_t>(arrived);
        if (filled > kLargestFile || static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) > kLargestFile)
            refuse_file(path, "is too large to be an input file", fmt::format("at most {} MiB", kLargestFile >> 20));
        if (filled == text.size()) text.resize(std::min(2 * text.size(), kLargestFile + 1));
    }
    text.resize(filled);
    return text;
}

/// Gives a value and all within it the place of the option that it came from.
void stand_at(Node& node, const Place& place) {
    node.place = place;
    for (Node& element : node.elements) stand_at(element, place);
    for (Entry& entry : node.entries) {
        entry.place = place;
        stand_at(entry.node, place);
    }
}

}  // namespace

Document parse_document(const std::string& name, const std::string& text) {
    Document document{.name = name, .lines = split_lines(text), .root = {}};
    if (const auto line = line_of_deep_key(text))
        throw document.error({.line = *line, .column = 1},
                             {.what = fmt::format("a key of more than {} names", kDeepestKey),
                              .allowed = fmt::format("dotted keys and headers of at most {} names", kDeepestKey),
                              .hint = ""});
    try {
        document.root = convert(toml::parse(text));
    } catch (const toml::parse_error& error) {
        throw document.error(
            place_of(error.source()),
            {.what = fmt::format("not valid TOML: {}", error.description()),
             .allowed = "lines such as  key = 1.5,  key = \"text\",  key = [1.0, 2.0],  [table],  # comment"});
    }
    document.root.place = {};
    return document;
}

Document read_document(const std::string& path) {
    note_input(path);
    return parse_document(path, read_text(path));
}

Node parse_option_value(const std::string& text, const Place& place) {
    Node node;
    if (line_of_deep_key(text))
        throw input_error("", "", place,
                          {.what = fmt::format("a key of more than {} names", kDeepestKey),
                           .allowed = "a value in TOML syntax, or a bare word",
                           .hint = ""});
    try {
        const toml::table table = toml::parse("value = " + text);
        if (table.size() == 1) {
            node = convert(*table.get("value"));
            stand_at(node, place);
            return node;
        }
    } catch (const toml::parse_error&) {
        // Not TOML: perhaps a number as programs print it, or a bare word.
    }
    double number = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    const auto is_bare = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::strchr("_-.", c) != nullptr;
    };
    if (status == std::errc() && end == text.data() + text.size() && !text.empty()) {
        node.kind = NodeKind::number;
        node.number = number;
    } else if (!text.empty() && text.find('\0') == std::string::npos &&
               std::all_of(text.begin(), text.end(), is_bare)) {
        node.kind = NodeKind::text;
        node.text = text;
    } else {
        throw input_error(
            "", "", place,
            {.what = fmt::format("'{}' is not a value", text), .allowed = "a value in TOML syntax, or a bare word"});
    }
    node.place = place;
    return node;
}

}  // namespace railpem::app

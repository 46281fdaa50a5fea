#pragma once
// A TOML file as a tree in which every key and every value knows where it stands. Nothing else in the program sees
// TOML.

#include <cstdint>
#include <string>
#include <vector>

#include "app/input_error.hpp"

namespace railpem::app {

enum class NodeKind { boolean, integer, number, text, date, array, table };

struct Entry;

/// A value of a TOML document; only the member of its kind means something. Control characters in keys and texts are
/// written out (recordings/files/visible_text.hpp): nothing that is shown later can forge what stands around it.
struct Node {
    NodeKind kind = NodeKind::table;
    bool boolean = false;
    std::int64_t integer = 0;
    double number = 0.0;
    std::string text;
    std::vector<Node> elements;  ///< array
    std::vector<Entry> entries;  ///< table, in the order of the document
    Place place;                 ///< of the value; of a table: its header

    Entry* find(const std::string& key);
    const Entry* find(const std::string& key) const;
};

struct Entry {
    std::string key;
    Place place;  ///< of the key
    Node node;
};

/// What kind of value it is, in words: "a number", "a text", "a list", …
std::string kind_text(NodeKind kind);

struct Document {
    std::string name;  ///< the file as the user called it
    std::vector<std::string> lines;
    Node root;

    /// The message for something wrong at a place of this document.
    InputError error(const Place& place, const Problem& problem) const;
};

/// Largest input file that is read, bytes: far more than a case with measured tables needs.
inline constexpr std::size_t kLargestFile = 16u << 20;

/// Reads and parses a file. Throws InputError when it cannot be read, is larger than kLargestFile or is not TOML.
Document read_document(const std::string& path);

/// The same for a text that is already there.
Document parse_document(const std::string& name, const std::string& text);

/// The value of an option `--set key=value` in TOML syntax; a bare word is a text, and 5. or .5 are numbers.
/// `place` becomes the place of the value and all within. Throws InputError when it is neither.
Node parse_option_value(const std::string& text, const Place& place);

}  // namespace railpem::app

#pragma once
// Descriptions of files as trees of tables, built from the field lists of the folders. A schema is bound to a struct;
// from it come the reader, the writer, `--set`, the "did you mean" and the reference page.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "parameters/field.hpp"

namespace railpem::app {

struct TableSchema;

/// A field of a struct that is known only by its address: the owner is what the schema was built for.
struct FieldSchema {
    parameters::Description description;
    std::function<parameters::Value(const void* owner)> get;
    std::function<void(void* owner, const parameters::Value&)> set;
};

/// [name]: a struct within the owner.
struct SubtableSchema {
    std::string name;
    std::string says;
    std::shared_ptr<const TableSchema> table;
    std::function<void*(void* owner)> member;
};

/// [[name]]: a vector of structs within the owner.
struct TableListSchema {
    std::string name;
    std::string says;
    std::shared_ptr<const TableSchema> table;
    std::function<std::size_t(const void* owner)> size;
    std::function<void*(void* owner, std::size_t)> at;
    std::function<void*(void* owner)> append;  ///< a new default element at the end
    std::shared_ptr<void> example;             ///< a default element: where defaults are read from
};

/// [name] whose keys are the dotted keys of numbers elsewhere in the same file.
struct KeyedNumbersSchema {
    std::string name;
    std::string says;
    parameters::Range range;
    std::function<std::map<std::string, double>&(void* owner)> member;
};

/// [[name]] whose elements are of several kinds, told by one of their keys. The tables of the kinds are bound to
/// elements of their own, not to the owner: whoever reads the file gathers them with read_variants().
struct VariantListSchema {
    std::string name;
    std::string says;
    std::string key;  ///< the key that tells the kind: every table below has it, as a choice
    std::map<std::string, std::shared_ptr<const TableSchema>> variants;
    std::shared_ptr<const TableSchema> unknown;  ///< while the kind is not known: the key alone

    /// The table of an element whose key has that value.
    const TableSchema& variant(const std::string& kind) const;
};

struct TableSchema {
    std::string note;                    ///< said where a key is unknown and nothing nearer helps; may be empty
    std::vector<std::string> note_keys;  ///< and where one of these is missing
    std::vector<FieldSchema> fields;
    std::vector<SubtableSchema> tables;
    std::vector<TableListSchema> lists;
    std::vector<KeyedNumbersSchema> keyed_numbers;
    std::vector<VariantListSchema> variant_lists;

    const FieldSchema* field(const std::string& key) const;
    const SubtableSchema* table(const std::string& name) const;
    const TableListSchema* list(const std::string& name) const;
    const KeyedNumbersSchema* keyed(const std::string& name) const;
    const VariantListSchema* variant_list(const std::string& name) const;
    /// Every name that may stand in the table.
    std::vector<std::string> names() const;
};

/// Builds the schema of an Owner struct; the only place that knows both the struct and the schema.
template <class Owner>
class Table {
  public:
    explicit Table(const parameters::Fields<Owner>& fields) : schema_(std::make_shared<TableSchema>()) {
        for (const parameters::Field<Owner>& field : fields)
            schema_->fields.push_back(
                {field.description,
                 [get = field.get](const void* owner) { return get(*static_cast<const Owner*>(owner)); },
                 [set = field.set](void* owner, const parameters::Value& value) {
                     set(*static_cast<Owner*>(owner), value);
                 }});
    }

    template <class Child>
    Table& table(std::string name, Child Owner::*member, std::string says, const Table<Child>& child) {
        schema_->tables.push_back({std::move(name), std::move(says), child.schema(),
                                   [member](void* owner) -> void* { return &(static_cast<Owner*>(owner)->*member); }});
        return *this;
    }

    template <class Child>
    Table& list(std::string name, std::vector<Child> Owner::*member, std::string says, const Table<Child>& child) {
        schema_->lists.push_back(
            {std::move(name), std::move(says), child.schema(),
             [member](const void* owner) { return (static_cast<const Owner*>(owner)->*member).size(); },
             [member](void* owner, std::size_t index) -> void* {
                 return &(static_cast<Owner*>(owner)->*member)[index];
             },
             [member](void* owner) -> void* { return &(static_cast<Owner*>(owner)->*member).emplace_back(); },
             std::make_shared<Child>()});
        return *this;
    }

    Table& keyed_numbers(std::string name, std::map<std::string, double> Owner::*member, std::string says,
                         parameters::Range range) {
        const auto within = [member](void* owner) -> std::map<std::string, double>& {
            return static_cast<Owner*>(owner)->*member;
        };
        schema_->keyed_numbers.push_back({std::move(name), std::move(says), range, within});
        return *this;
    }

    Table& note(std::string text, std::vector<std::string> missing_keys) {
        schema_->note = std::move(text);
        schema_->note_keys = std::move(missing_keys);
        return *this;
    }

    Table& variants(VariantListSchema list) {
        schema_->variant_lists.push_back(std::move(list));
        return *this;
    }

    std::shared_ptr<const TableSchema> schema() const { return schema_; }

  private:
    std::shared_ptr<TableSchema> schema_;
};

/// What a field may be, for messages and the reference page: "a number greater than 0, in kg".
std::string allowed_text(const parameters::Description& description);

/// One step of a dotted key: a name, and the element where it is a list, counted from 1 (0: not stated).
struct Step {
    std::string name;
    std::size_t element = 0;
};

/// "irregularity.band[2].exponent" (or "irregularity.band.2.exponent") in steps.
std::vector<Step> key_steps(const std::string& key);
std::string key_text(const std::vector<Step>& steps);

/// The field that a dotted key means, elements of lists stated or not; nullptr when there is none.
const FieldSchema* find_field(const TableSchema& schema, const std::vector<Step>& steps);

/// Dotted keys of every field that is a number, without elements of lists: "irregularity.band.exponent".
std::vector<std::string> number_keys(const TableSchema& schema);

/// Dotted keys of the fields of that name anywhere below, without elements of lists.
std::vector<std::string> keys_named(const TableSchema& schema, const std::string& name);

/// "did you mean 'body_mass_kg'?" for a name that a table does not know: the nearest of its own names, else the same
/// name in another table of the file, else the table's note. May be empty.
std::string did_you_mean(const std::string& unknown, const TableSchema& table, const TableSchema& root);

}  // namespace railpem::app

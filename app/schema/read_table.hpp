#pragma once

#include <functional>
#include <string>

#include "app/refusals.hpp"
#include "app/schema/document.hpp"
#include "app/schema/schema.hpp"
#include "parameters/parameter_error.hpp"

namespace railpem::app {

/// Fills `owner` (the struct the schema was built for, with its defaults) from the tree of a file. Every key must be
/// known, of the right kind and in its range, every required key present. Throws InputError.
/// Elements of variant lists are left to read_variants(). With `all` nothing is thrown: every refusal is added to it.
void read_table(const Document& document, const TableSchema& schema, void* owner, Refusals* all = nullptr);

/// Reads the elements of a variant list at the top of the file, each into the struct that `append` returns for it (of
/// the kind that `kind` names). Throws InputError, unless there is `all`.
void read_variants(const Document& document, const TableSchema& root, const VariantListSchema& list,
                   const std::function<void*(const std::string& kind)>& append, Refusals* all = nullptr);

/// Where a dotted key stands: its value, else the innermost table around it.
Place place_of(const Document& document, const std::string& key);

/// The message for a broken rule of physics: at the value it names, else at the innermost table around it.
InputError refused(const Document& document, const parameters::ParameterError& error);

/// A dotted key within a table ("" for the top of the file), and the table as messages call it: "[vehicle]".
std::string inner_key(const std::string& path, const std::string& name);
std::string table_text(const std::string& path);

/// What is wrong with a key or table that `table` (at `path`) does not know.
Problem unknown_key(const Entry& entry, const TableSchema& table, const std::string& path, const TableSchema& root);

}  // namespace railpem::app

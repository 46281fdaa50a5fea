#pragma once
// What a MATLAB file holds, as a tree: the same for every version of the format.

#include <cstddef>
#include <string>
#include <vector>

namespace railpem::recordings {

enum class MatKind { numbers, complex, text, cell, structure, sparse, object };

/// A value and what is in it. Sizes are MATLAB's, the first counts rows.
struct MatValue {
    MatKind kind = MatKind::object;
    std::string class_name;           ///< of an object, such as table
    std::vector<std::size_t> sizes;   ///< of every dimension; empty for an object
    std::vector<std::string> fields;  ///< of a structure
    /// Cell: its elements, column by column. Structure: all fields of its first element, then of the next.
    std::vector<MatValue> parts;
    std::size_t stored = 0;  ///< numbers: where the file's reader finds them

    std::size_t elements() const {
        std::size_t product = sizes.empty() ? 0 : 1;
        for (const std::size_t size : sizes) product *= size;
        return product;
    }
};

struct MatVariable {
    std::string name;
    MatValue value;
};

/// One channel of a value of numbers: how they follow each other in the file, which stores column by column.
struct MatColumn {
    std::size_t stored = 0;  ///< as in MatValue
    std::size_t first = 0, step = 1, count = 0;
};

}  // namespace railpem::recordings

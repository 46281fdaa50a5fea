#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "recordings/files/data_table.hpp"
#include "recordings/files/isolated_read.hpp"
#include "recordings/files/read_error.hpp"

namespace railpem::recordings {

/// Sends `length` rows of the table in blocks of at most `rows`: `fill` appends rows `begin` to `begin + count` to the
/// table's columns. Throws ReadError when a block needs more memory than allowed.
inline void send_blocks(DataTable& table, std::size_t length, std::size_t rows, const ReadLimits& limits,
                        const std::string& file, const SendTable& send,
                        const std::function<void(std::size_t begin, std::size_t count)>& fill) {
    const std::size_t columns = table.names.size(), block = std::min(rows, length);
    if (columns > limits.columns || (columns > 0 && block > limits.memory_bytes / sizeof(double) / columns))
        throw ReadError(
            file, 0, fmt::format("{} channels of {} samples are too many", columns, length),
            fmt::format("at most {} channels, {} MB of numbers", limits.columns, limits.memory_bytes >> 20));
    table.columns.assign(columns, {});
    table.says.held_rows = length;
    for (std::size_t begin = 0; begin < length || begin == 0; begin += block) {
        for (auto& column : table.columns) {
            column.clear();
            column.reserve(block);
        }
        fill(begin, std::min(block, length - begin));
        send(table);
        table.notes.clear();
        if (length == 0) break;
    }
}

}  // namespace railpem::recordings

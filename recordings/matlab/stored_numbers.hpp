#pragma once

#include <cstdint>
#include <vector>

#include "recordings/matlab/byte_stream.hpp"
#include "recordings/matlab/mat_value.hpp"

namespace railpem::recordings {

enum class NumberType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, single_float, double_float };

std::size_t bytes_of(NumberType type);

/// Numbers of one type that lie one behind the other.
struct StoredNumbers {
    std::uint64_t position = 0;  ///< of the first in its stream
    std::size_t count = 0;       ///< that are there
    NumberType type = NumberType::double_float;
    bool swapped = false;    ///< the other order of bytes than this machine's
    std::size_t stream = 0;  ///< which stream, where the file has several
};

/// Appends numbers `begin` to `begin + count` of the channel.
void append_numbers(ByteStream& stream, const StoredNumbers& stored, const MatColumn& channel, std::size_t begin,
                    std::size_t count, std::vector<double>& values);

/// `value` with its bytes in the other order.
std::uint32_t swapped_bytes(std::uint32_t value);

}  // namespace railpem::recordings

#include "recordings/matlab/stored_numbers.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace railpem::recordings {
namespace {

constexpr std::size_t numbers_per_read = 8192;

/// Every `step`-th of the numbers in the bytes, from the first.
template <class Number>
void append_as(const char* bytes, std::size_t numbers, std::size_t step, bool swapped, std::vector<double>& values) {
    for (std::size_t i = 0; i < numbers; i += step) {
        std::array<char, sizeof(Number)> own;
        std::memcpy(own.data(), bytes + i * sizeof(Number), sizeof(Number));
        if (swapped) std::reverse(own.begin(), own.end());
        Number number;
        std::memcpy(&number, own.data(), sizeof(Number));
        values.push_back(static_cast<double>(number));
    }
}

using Append = void (*)(const char*, std::size_t, std::size_t, bool, std::vector<double>&);

Append append_of(NumberType type) {
    static const Append all[] = {append_as<std::int8_t>,   append_as<std::uint8_t>,  append_as<std::int16_t>,
                                 append_as<std::uint16_t>, append_as<std::int32_t>,  append_as<std::uint32_t>,
                                 append_as<std::int64_t>,  append_as<std::uint64_t>, append_as<float>,
                                 append_as<double>};
    return all[static_cast<int>(type)];
}

}  // namespace

std::size_t bytes_of(NumberType type) {
    static constexpr std::size_t all[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return all[static_cast<int>(type)];
}

void append_numbers(ByteStream& stream, const StoredNumbers& stored, const MatColumn& channel, std::size_t begin,
                    std::size_t count, std::vector<double>& values) {
    const std::size_t size = bytes_of(stored.type);
    const Append append = append_of(stored.type);
    const std::size_t step = channel.step;
    const std::size_t wanted_at_once = std::max<std::size_t>(1, numbers_per_read / step);
    std::vector<char> bytes;
    for (std::size_t done = 0; done < count;) {
        const std::size_t now = std::min(wanted_at_once, count - done);
        const std::size_t numbers = (now - 1) * step + 1;
        stream.seek(stored.position + (channel.first + (begin + done) * step) * size);
        bytes.resize(numbers * size);
        stream.read(bytes.data(), bytes.size());
        append(bytes.data(), numbers, step, stored.swapped, values);
        done += now;
    }
}

std::uint32_t swapped_bytes(std::uint32_t value) {
    return value << 24 | (value << 8 & 0xFF0000U) | (value >> 8 & 0xFF00U) | value >> 24;
}

}  // namespace railpem::recordings

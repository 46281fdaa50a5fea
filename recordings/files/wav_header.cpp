#include "recordings/files/wav_header.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <limits>

namespace railpem::recordings {
namespace {

constexpr std::uint32_t open_size = std::numeric_limits<std::uint32_t>::max();

template <class Number>
Number little_endian(const char* bytes) {
    Number value = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        value = static_cast<Number>(value | (static_cast<Number>(static_cast<unsigned char>(bytes[i])) << (8 * i)));
    return value;
}

bool is(const char* bytes, const char* id) {
    return std::memcmp(bytes, id, 4) == 0;
}

/// PCM, floating point, A-law, mu-law and the extensible form: a frame has a fixed length, which blocks of compressed
/// samples have not.
bool has_frames(std::uint16_t format) {
    return format == 1 || format == 3 || format == 6 || format == 7 || format == 0xFFFE;
}

/// A chain of chunks from `at` that ends with the file: what stands behind the samples of a complete file.
bool chunks_to_the_end(std::ifstream& in, std::uint64_t at, std::uint64_t size) {
    std::array<char, 8> head{};
    while (at + head.size() <= size) {
        in.clear();
        in.seekg(static_cast<std::streamoff>(at));
        if (!in.read(head.data(), head.size())) return false;
        for (std::size_t i = 0; i < 4; ++i)
            if (head[i] < ' ' || head[i] > '~') return false;
        const std::uint64_t length = little_endian<std::uint32_t>(head.data() + 4);
        at += head.size() + length + length % 2;
    }
    return at >= size && at <= size + 1;
}

void take_data(std::ifstream& in, std::uint64_t at, std::uint64_t file_bytes, std::uint64_t long_size, bool is_riff,
               std::uint32_t stated, WavHeader& header) {
    header.size_at = at + 4;
    header.data_at = at + 8;
    header.held_bytes = file_bytes - header.data_at;
    header.stated_bytes = stated == open_size && long_size > 0 ? long_size : stated;
    const std::uint64_t behind = header.data_at + header.stated_bytes + header.stated_bytes % 2;
    const bool more = behind < file_bytes && !chunks_to_the_end(in, behind, file_bytes);
    header.size_is_open =
        is_riff && ((stated == open_size && long_size == 0) || (stated == 0 && more && header.held_bytes > 0));
    header.goes_on = more && !header.size_is_open;
}

}  // namespace

std::optional<WavHeader> read_wav_header(const std::string& file) {
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    const auto file_bytes = static_cast<std::uint64_t>(std::max<std::streamoff>(0, in.tellg()));
    std::array<char, 12> head{};
    in.seekg(0);
    if (!in.read(head.data(), head.size()) || !is(head.data() + 8, "WAVE")) return std::nullopt;
    const bool is_riff = is(head.data(), "RIFF");
    if (!is_riff && !is(head.data(), "RF64")) return std::nullopt;
    WavHeader header;
    std::uint64_t long_size = 0;
    for (std::uint64_t at = head.size(); at + 8 <= file_bytes;) {
        std::array<char, 32> chunk{};
        in.clear();
        in.seekg(static_cast<std::streamoff>(at));
        in.read(chunk.data(), chunk.size());
        const auto length = little_endian<std::uint32_t>(chunk.data() + 4);
        if (is(chunk.data(), "ds64")) long_size = little_endian<std::uint64_t>(chunk.data() + 16);
        if (is(chunk.data(), "fmt ") && has_frames(little_endian<std::uint16_t>(chunk.data() + 8)))
            header.bytes_per_frame = little_endian<std::uint16_t>(chunk.data() + 20);
        if (is(chunk.data(), "data")) {
            take_data(in, at, file_bytes, long_size, is_riff, length, header);
            return header;
        }
        at += 8 + std::uint64_t{length} + length % 2;
    }
    return std::nullopt;
}

}  // namespace railpem::recordings

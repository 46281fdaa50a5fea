#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace railpem::recordings {

/// Bytes that are read forwards, with jumps. Throws ReadError where they end early.
class ByteStream {
  public:
    virtual ~ByteStream() = default;
    virtual void read(void* data, std::size_t bytes) = 0;
    /// A jump back in deflated bytes begins again in front.
    virtual void seek(std::uint64_t position) = 0;
    virtual std::uint64_t position() const = 0;
};

/// The bytes [begin, begin + size) of the file as they stand.
std::unique_ptr<ByteStream> plain_bytes(const std::string& file, std::uint64_t begin, std::uint64_t size);
/// What a zlib stream in those bytes inflates to.
std::unique_ptr<ByteStream> inflated_bytes(const std::string& file, std::uint64_t begin, std::uint64_t size);

}  // namespace railpem::recordings

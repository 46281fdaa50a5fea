#include "recordings/matlab/byte_stream.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <vector>

#include "recordings/files/read_error.hpp"

namespace railpem::recordings {
namespace {

[[noreturn]] void fail_at_end(const std::string& file) {
    throw ReadError(file, 0, "the file is truncated: a variable is cut short", "a complete .mat file");
}

class PlainBytes : public ByteStream {
  public:
    PlainBytes(const std::string& file, std::uint64_t begin, std::uint64_t size)
        : file_(file), in_(file, std::ios::binary), begin_(begin), size_(size) {
        if (!in_) throw ReadError(file, 0, "cannot be opened", "a file that may be read");
        in_.seekg(static_cast<std::streamoff>(begin));
    }
    void read(void* data, std::size_t bytes) override {
        if (bytes > size_ - at_ || !in_.read(static_cast<char*>(data), static_cast<std::streamsize>(bytes)))
            fail_at_end(file_);
        at_ += bytes;
    }
    void seek(std::uint64_t position) override {
        if (position > size_) fail_at_end(file_);
        if (position != at_) in_.seekg(static_cast<std::streamoff>(begin_ + position));
        at_ = position;
    }
    std::uint64_t position() const override { return at_; }

  private:
    std::string file_;
    std::ifstream in_;
    std::uint64_t begin_, size_, at_ = 0;
};

class InflatedBytes : public ByteStream {
  public:
    InflatedBytes(const std::string& file, std::uint64_t begin, std::uint64_t size)
        : file_(file), size_(size), source_(file, begin, size) {
        if (inflateInit(&state_) != Z_OK) throw std::bad_alloc();
    }
    ~InflatedBytes() override { inflateEnd(&state_); }
    InflatedBytes(const InflatedBytes&) = delete;
    InflatedBytes& operator=(const InflatedBytes&) = delete;

    void read(void* data, std::size_t bytes) override {
        auto* at = static_cast<Bytef*>(data);
        for (std::size_t left = bytes; left > 0;) {
            const std::size_t piece = std::min<std::size_t>(left, 1U << 30);
            state_.next_out = at;
            state_.avail_out = static_cast<uInt>(piece);
            while (state_.avail_out > 0) inflate_some();
            at += piece;
            left -= piece;
        }
        at_ += bytes;
    }
    void seek(std::uint64_t position) override {
        if (position < at_) {
            inflateReset(&state_);
            source_.seek(0);
            state_.avail_in = 0;
            at_ = 0;
        }
        std::array<char, 65536> passed;
        while (at_ < position) read(passed.data(), std::min<std::uint64_t>(passed.size(), position - at_));
    }
    std::uint64_t position() const override { return at_; }

  private:
    void inflate_some() {
        if (state_.avail_in == 0) {
            const std::size_t more = std::min<std::uint64_t>(buffer_.size(), size_ - source_.position());
            if (more == 0) fail_at_end(file_);
            source_.read(buffer_.data(), more);
            state_.next_in = buffer_.data();
            state_.avail_in = static_cast<uInt>(more);
        }
        const uInt before = state_.avail_out;
        const int result = inflate(&state_, Z_NO_FLUSH);
        if (result == Z_STREAM_END && state_.avail_out > 0) fail_at_end(file_);
        if (result != Z_OK && result != Z_STREAM_END && !(result == Z_BUF_ERROR && state_.avail_out < before))
            throw ReadError(file_, 0, fmt::format("its compressed data are damaged ({})", zError(result)),
                            "an undamaged file");
    }

    std::string file_;
    std::uint64_t size_, at_ = 0;
    PlainBytes source_;
    z_stream state_{};
    std::vector<Bytef> buffer_ = std::vector<Bytef>(65536);
};

}  // namespace

std::unique_ptr<ByteStream> plain_bytes(const std::string& file, std::uint64_t begin, std::uint64_t size) {
    return std::make_unique<PlainBytes>(file, begin, size);
}

std::unique_ptr<ByteStream> inflated_bytes(const std::string& file, std::uint64_t begin, std::uint64_t size) {
    return std::make_unique<InflatedBytes>(file, begin, size);
}

}  // namespace railpem::recordings

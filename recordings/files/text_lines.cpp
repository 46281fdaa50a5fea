#include "recordings/files/text_lines.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "recordings/files/read_error.hpp"

namespace railpem::recordings {

struct TextLines::Stream {
    gzFile handle = nullptr;
    ~Stream() {
        if (handle) gzclose(handle);
    }
};

namespace {
constexpr std::size_t smallest_chunk_bytes = std::size_t{1} << 12, chunk_bytes = std::size_t{1} << 18;
const char* const text_wanted = "a text file in UTF-8, or one compressed by gzip";
}  // namespace

TextLines::TextLines(std::string file, const ReadLimits& limits)
    : file_(std::move(file)), stream_(std::make_unique<Stream>()), limit_(limits.line_bytes) {
    struct stat status {};
    if (stat(file_.c_str(), &status) != 0)
        throw ReadError(file_, 0, fmt::format("cannot be opened ({})", std::strerror(errno)),
                        "a file that exists and may be read");
    if (!S_ISREG(status.st_mode)) throw ReadError(file_, 0, "is not a file", "a regular file");
    stream_->handle = gzopen(file_.c_str(), "rb");
    if (!stream_->handle)
        throw ReadError(file_, 0, fmt::format("cannot be opened ({})", std::strerror(errno)),
                        "a file that exists and may be read");
    // A small file needs no large buffers; a compressed one makes its buffer grow.
    buffer_.resize(std::clamp(static_cast<std::size_t>(status.st_size), smallest_chunk_bytes, chunk_bytes));
    gzbuffer(stream_->handle, static_cast<unsigned>(buffer_.size() / 2));
    refill();
    if (begin_ == end_) throw ReadError(file_, 0, "the file is empty", text_wanted);
    const auto starts_with = [&](std::string_view mark) {
        return end_ >= mark.size() && std::string_view(buffer_.data(), mark.size()) == mark;
    };
    if (starts_with("\xFF\xFE") || starts_with("\xFE\xFF"))
        throw ReadError(file_, 1, "the text is encoded as UTF-16", text_wanted);
    if (starts_with("\xEF\xBB\xBF")) begin_ = 3;  // the byte order mark of UTF-8 is not part of the first name
}

TextLines::~TextLines() = default;
TextLines::TextLines(TextLines&&) noexcept = default;

/// Moves what is left to the front and reads more behind it. False when nothing came.
bool TextLines::refill() {
    if (at_end_) return false;
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    for (Found* found : {&feed_, &return_}) {
        const std::size_t looked_at = found->known ? found->at : found->searched_to;
        *found = {false, 0, std::max(looked_at, begin_) - begin_};
    }
    end_ -= begin_;
    begin_ = 0;
    if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
    const int got = gzread(stream_->handle, buffer_.data() + end_, static_cast<unsigned>(buffer_.size() - end_));
    int code = Z_OK;
    const char* message = gzerror(stream_->handle, &code);
    // A truncated member is reported as Z_BUF_ERROR, at times only after its last bytes were handed out.
    if (got < 0 || code == Z_BUF_ERROR || code == Z_DATA_ERROR)
        throw ReadError(file_, line_number_ + 1,
                        fmt::format("the compressed file is damaged or truncated ({})", message),
                        "a complete gzip file");
    if (got == 0) {
        at_end_ = true;
        return false;
    }
    end_ += static_cast<std::size_t>(got);
    return true;
}

/// Where the first `sign` at or after begin_ stands, or end_: looked for once, not again for every line before it.
std::size_t TextLines::next_sign(char sign, Found& found) {
    if (found.known && found.at >= begin_) return found.at;
    const std::size_t from = std::max(begin_, found.known ? begin_ : found.searched_to);
    const void* at = from < end_ ? std::memchr(buffer_.data() + from, sign, end_ - from) : nullptr;
    found.known = at != nullptr;
    found.at = at ? static_cast<std::size_t>(static_cast<const char*>(at) - buffer_.data()) : end_;
    found.searched_to = end_;
    return found.at;
}

void TextLines::take_line(std::size_t stop, std::size_t sign_bytes, std::string_view& line) {
    line = std::string_view(buffer_.data() + begin_, stop - begin_);
    begin_ = stop + sign_bytes;
    cut_ = sign_bytes == 0;
    ++line_number_;
    if (std::memchr(line.data(), '\0', line.size()))
        throw ReadError(file_, line_number_, "a zero byte: this is not text", text_wanted);
}

bool TextLines::next(std::string_view& line) {
    for (;;) {
        const std::size_t feed = next_sign('\n', feed_), carriage = next_sign('\r', return_);
        const bool return_is_last = carriage + 1 == end_ && !at_end_;  // a line feed may follow, still unread
        if (feed < carriage) {
            take_line(feed, 1, line);
            return true;
        }
        if (carriage < end_ && !return_is_last) {
            take_line(carriage, feed == carriage + 1 ? 2 : 1, line);
            return true;
        }
        if (at_end_ && begin_ < end_) {
            take_line(end_, 0, line);
            return true;
        }
        if (at_end_) return false;
        if (end_ - begin_ > limit_)
            throw ReadError(file_, line_number_ + 1, fmt::format("a line of more than {} bytes", limit_),
                            "a table with line ends LF, CR LF or CR");
        refill();
    }
}

}  // namespace railpem::recordings

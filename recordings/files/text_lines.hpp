#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/files/data_table.hpp"

namespace railpem::recordings {

/// Lines of a plain or gzip-compressed text file, in bounded memory whatever the file holds.
class TextLines {
  public:
    /// Throws ReadError when the file cannot be opened, is empty, or begins like UTF-16.
    TextLines(std::string file, const ReadLimits& limits);
    ~TextLines();
    TextLines(TextLines&&) noexcept;

    /// The next line without its end (LF, CR LF or CR), or false at the end of the file. The view is valid until the
    /// next call. Throws ReadError for a damaged compressed file, a line longer than the limit, or a zero byte.
    bool next(std::string_view& line);

    std::size_t line_number() const { return line_number_; }  ///< of the line last returned, from 1
    bool last_line_was_cut() const { return cut_; }  ///< the line last returned had no line end: the file stops there
    const std::string& file() const { return file_; }

  private:
    struct Stream;
    /// Of a sign that ends lines: where the next one is, if it is known, and up to where there is none.
    struct Found {
        bool known = false;
        std::size_t at = 0, searched_to = 0;
    };
    bool refill();
    std::size_t next_sign(char sign, Found& found);
    void take_line(std::size_t stop, std::size_t sign_bytes, std::string_view& line);

    std::string file_;
    std::unique_ptr<Stream> stream_;
    std::vector<char> buffer_;
    std::size_t limit_ = 0;
    std::size_t begin_ = 0, end_ = 0;
    Found feed_, return_;
    std::size_t line_number_ = 0;
    bool at_end_ = false;
    bool cut_ = false;
};

}  // namespace railpem::recordings

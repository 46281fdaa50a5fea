#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

#include "recordings/files/read_error.hpp"
#include "recordings/files/text_encoding.hpp"
#include "recordings/files/uff.hpp"

namespace railpem::recordings {
namespace {

const char* const uff_wanted = "universal file datasets 58 or 58b, complete";

std::string_view without_blanks(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

/// The file held as a whole, walked line by line or byte by byte.
class Walker {
  public:
    Walker(std::string file, std::string content) : file_(std::move(file)), content_(std::move(content)) {}

    bool next(std::string_view& line) {
        if (at_ >= content_.size()) return false;
        const std::size_t end = std::min(content_.find('\n', at_), content_.size());
        line = std::string_view(content_).substr(at_, end - at_);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        at_ = end + 1;
        ++line_;
        return true;
    }
    std::string_view require(const char* what) {
        std::string_view line;
        if (!next(line)) fail(fmt::format("the file ends before {}", what));
        return line;
    }
    std::string_view bytes(std::size_t count) {
        if (at_ > content_.size() || count > content_.size() - at_) fail("the file ends in the middle of binary data");
        const std::string_view view = std::string_view(content_).substr(at_, count);
        at_ += count;
        return view;
    }
    std::size_t left() const { return at_ < content_.size() ? content_.size() - at_ : 0; }
    std::size_t position() const { return at_; }
    std::size_t line_number() const { return line_; }
    void step_back(std::size_t position, std::size_t line) {
        at_ = position;
        line_ = line;
    }
    [[noreturn]] void fail(const std::string& problem) const { throw ReadError(file_, line_, problem, uff_wanted); }

  private:
    std::string file_, content_;
    std::size_t at_ = 0, line_ = 0;
};

/// A whole number in a fixed-width field; blank: 0.
long integer_in(const Walker& walker, std::string_view line, std::size_t begin, std::size_t width) {
    std::string_view field = begin < line.size() ? without_blanks(line.substr(begin, width)) : std::string_view();
    if (field.empty()) return 0;
    if (field.front() == '+') field.remove_prefix(1);
    long value = 0;
    const auto [stop, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || stop != field.data() + field.size())
        walker.fail(fmt::format("columns {} to {} do not hold a whole number", begin + 1, begin + width));
    return value;
}

int small_integer_in(const Walker& walker, std::string_view line, std::size_t begin, std::size_t width) {
    const long value = integer_in(walker, line, begin, width);
    if (value < -1000000000L || value > 1000000000L)
        walker.fail(fmt::format("columns {} to {} hold a number out of range", begin + 1, begin + width));
    return static_cast<int>(value);
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Fortran leaves the E out where the exponent has three digits: 1.234-101. False when such a number is out of range.
bool take_bare_exponent(std::string_view& text, double& value) {
    if (text.size() < 4 || (text[0] != '+' && text[0] != '-') || !is_digit(text[1]) || !is_digit(text[2]) ||
        !is_digit(text[3]) || (text.size() > 4 && (is_digit(text[4]) || text[4] == '.')))
        return true;
    const int exponent = 100 * (text[1] - '0') + 10 * (text[2] - '0') + (text[3] - '0');
    value *= std::pow(10.0, text[0] == '-' ? -exponent : exponent);
    text.remove_prefix(4);
    return std::isfinite(value);
}

/// Takes the next number off the text; Fortran's D exponents are read like E. False when there is none.
bool take_number(std::string_view& text, double& value) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    if (text.empty()) return false;
    char copy[40];
    const std::size_t length = std::min(text.size(), sizeof copy);
    for (std::size_t i = 0; i < length; ++i) copy[i] = text[i] == 'D' || text[i] == 'd' ? 'E' : text[i];
    const auto [stop, error] = std::from_chars(copy, copy + length, value);
    if (error == std::errc::result_out_of_range) value = 0.0;
    if (stop == copy || (error != std::errc() && error != std::errc::result_out_of_range)) return false;
    text.remove_prefix(static_cast<std::size_t>(stop - copy));
    if (!std::memchr(copy, 'E', static_cast<std::size_t>(stop - copy)) && !take_bare_exponent(text, value))
        return false;
    return true;
}

double number_in(const Walker& walker, std::string_view line, std::size_t begin, std::size_t width) {
    std::string_view field = begin < line.size() ? without_blanks(line.substr(begin, width)) : std::string_view();
    if (field.empty()) return 0.0;
    double value = 0.0;
    if (!take_number(field, value) || !field.empty() || !std::isfinite(value))
        walker.fail(fmt::format("columns {} to {} do not hold a number", begin + 1, begin + width));
    return value;
}

struct Binary {
    bool is = false;
    bool big_endian = false;
    std::size_t bytes = 0;
};

std::string text_of(std::string_view text) {
    bool converted = false;
    return to_utf8(without_blanks(text.substr(0, 80)), converted);
}

std::string field_text(std::string_view line, std::size_t begin, std::size_t width) {
    return begin < line.size() ? text_of(line.substr(begin, width)) : std::string();
}

/// A unit; "NONE" and blanks are none.
std::string unit_text(std::string_view line, std::size_t begin, std::size_t width) {
    const std::string unit = field_text(line, begin, width);
    return unit == "NONE" || unit == "None" || unit == "none" || unit == "-" ? "" : unit;
}

Binary binary_header(const Walker& walker, std::string_view line) {
    Binary binary;
    binary.is = line.size() > 6 && (line[6] == 'b' || line[6] == 'B');
    if (!binary.is) return binary;
    const long order = integer_in(walker, line, 7, 6), format = integer_in(walker, line, 13, 6);
    if (order != 1 && order != 2) walker.fail(fmt::format("byte order {} of the binary data", order));
    if (format != 2) walker.fail("floating-point numbers that are not IEEE 754");
    const long bytes = integer_in(walker, line, 31, 12);
    if (bytes < 0) walker.fail("a negative number of bytes");
    binary.big_endian = order == 2;
    binary.bytes = static_cast<std::size_t>(bytes);
    return binary;
}

/// Records 1 to 11: everything before the data.
struct Layout {
    int ordinate_type = 4;  ///< 2, 4 real and 5, 6 complex, single and double
    std::size_t points = 0;
    bool even = true;
};

/// Record 7 of programs that do not keep to its columns: numbers with blanks between.
bool read_loose_record_7(std::string_view line, Layout& layout, UffDataset& dataset) {
    double numbers[5] = {};
    for (double& number : numbers)
        if (!take_number(line, number)) return false;
    for (int i = 0; i < 3; ++i)
        if (numbers[i] != std::floor(numbers[i]) || numbers[i] < 0.0 || numbers[i] > 1e9) return false;
    layout.ordinate_type = static_cast<int>(numbers[0]);
    layout.points = static_cast<std::size_t>(numbers[1]);
    layout.even = numbers[2] == 1.0;
    dataset.abscissa_start = numbers[3];
    dataset.abscissa_step = numbers[4];
    return std::isfinite(numbers[3]) && std::isfinite(numbers[4]);
}

void read_fixed_record_7(const Walker& walker, std::string_view line, Layout& layout, UffDataset& dataset) {
    layout.ordinate_type = small_integer_in(walker, line, 0, 10);
    const long points = integer_in(walker, line, 10, 10);
    if (points < 0) walker.fail(fmt::format("{} values", points));
    layout.points = static_cast<std::size_t>(points);
    layout.even = integer_in(walker, line, 20, 10) == 1;
    dataset.abscissa_start = number_in(walker, line, 30, 13);
    dataset.abscissa_step = number_in(walker, line, 43, 13);
}

Layout read_record_7(Walker& walker, UffDataset& dataset) {
    const std::string_view line = walker.require("record 7 of a dataset 58");
    Layout layout;
    try {
        read_fixed_record_7(walker, line, layout, dataset);
    } catch (const ReadError&) {
        if (!read_loose_record_7(line, layout, dataset)) throw;
    }
    if (layout.ordinate_type != 2 && layout.ordinate_type != 4 && layout.ordinate_type != 5 &&
        layout.ordinate_type != 6)
        walker.fail(fmt::format("ordinates of type {}", layout.ordinate_type));
    dataset.complex = layout.ordinate_type >= 5;
    if (layout.even && layout.points > 1 && !(dataset.abscissa_step > 0.0))
        walker.fail("an even abscissa whose step is not positive");
    return layout;
}

Layout read_records(Walker& walker, UffDataset& dataset) {
    for (std::string& id : dataset.id) id = text_of(walker.require("the five text lines of a dataset 58"));
    std::string_view line = walker.require("record 6 of a dataset 58");
    dataset.function_type = small_integer_in(walker, line, 0, 5);
    dataset.response_entity = field_text(line, 31, 10);
    dataset.response_node = small_integer_in(walker, line, 41, 10);
    dataset.response_direction = small_integer_in(walker, line, 51, 4);
    dataset.reference_entity = field_text(line, 56, 10);
    dataset.reference_node = small_integer_in(walker, line, 66, 10);
    dataset.reference_direction = small_integer_in(walker, line, 76, 4);

    Layout layout = read_record_7(walker, dataset);
    const auto axis = [&](int& kind, std::string& unit, const char* what) {
        const std::string_view record = walker.require(what);
        kind = small_integer_in(walker, record, 0, 10);
        unit = unit_text(record, 47, 20);
    };
    axis(dataset.abscissa_kind, dataset.abscissa_unit, "record 8 of a dataset 58");
    axis(dataset.ordinate_kind, dataset.ordinate_unit, "record 9 of a dataset 58");
    axis(dataset.denominator_kind, dataset.denominator_unit, "record 10 of a dataset 58");
    walker.require("record 11 of a dataset 58");
    return layout;
}

void store(UffDataset& dataset, const Layout& layout, std::size_t place, double value) {
    const std::size_t per_point = (layout.even ? 0 : 1) + (dataset.complex ? 2 : 1);
    std::size_t within = place % per_point;
    if (!layout.even && within == 0) {
        dataset.abscissa.push_back(value);
        return;
    }
    within -= layout.even ? 0 : 1;
    (within == 0 ? dataset.real : dataset.imaginary).push_back(value);
}

void read_text_data(Walker& walker, const Layout& layout, UffDataset& dataset) {
    const std::size_t count = layout.points * ((layout.even ? 0 : 1) + (dataset.complex ? 2 : 1));
    if (layout.points > walker.left())
        walker.fail(fmt::format("{} values are promised, more than the file can hold", layout.points));
    for (std::size_t done = 0; done < count;) {
        std::string_view line = walker.require("the last value of a dataset 58");
        if (without_blanks(line) == "-1")
            walker.fail(fmt::format("the dataset ends here: {} of its {} numbers are there", done, count));
        double value = 0.0;
        std::size_t in_line = 0;
        for (; done < count && take_number(line, value); ++done, ++in_line) store(dataset, layout, done, value);
        if (in_line == 0 || !without_blanks(line).empty())
            walker.fail("a line of data that does not hold numbers only");
    }
}

template <class Number, class Bits>
double number_of(std::string_view bytes, bool big_endian) {
    Bits bits = 0;
    for (std::size_t i = 0; i < sizeof(Bits); ++i) {
        const std::size_t from = big_endian ? i : sizeof(Bits) - 1 - i;
        bits = static_cast<Bits>((bits << 8) | static_cast<unsigned char>(bytes[from]));
    }
    return static_cast<double>(std::bit_cast<Number>(bits));
}

void read_binary_data(Walker& walker, const Binary& binary, const Layout& layout, UffDataset& dataset) {
    const bool single = layout.ordinate_type == 2 || layout.ordinate_type == 5;
    const std::size_t ordinate_bytes = single ? 4 : 8;
    // The abscissa of uneven data is always of single precision.
    const std::size_t per_point = (layout.even ? 0 : 4) + (dataset.complex ? 2 : 1) * ordinate_bytes;
    if (layout.points > walker.left() / per_point) walker.fail("the file ends in the middle of binary data");
    if (binary.bytes != layout.points * per_point)
        walker.fail(fmt::format("{} bytes of data are announced where {} values need {}", binary.bytes, layout.points,
                                layout.points * per_point));
    const std::string_view data = walker.bytes(binary.bytes);
    for (std::size_t place = 0, at = 0; at < data.size(); ++place) {
        const bool is_abscissa = !layout.even && place % (dataset.complex ? 3 : 2) == 0;
        const bool is_single = single || is_abscissa;
        store(dataset, layout, place,
              is_single ? number_of<float, std::uint32_t>(data.substr(at, 4), binary.big_endian)
                        : number_of<double, std::uint64_t>(data.substr(at, 8), binary.big_endian));
        at += is_single ? 4 : 8;
    }
}

void require_end_mark(Walker& walker) {
    std::string_view line = walker.require("the end mark -1 of a dataset 58");
    if (without_blanks(line).empty()) line = walker.require("the end mark -1 of a dataset 58");  // after binary data
    if (without_blanks(line) != "-1") walker.fail("the end mark -1 is missing");
}

std::string read_whole(const std::string& file, const ReadLimits& limits) {
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    if (!stream) throw ReadError(file, 0, "cannot be opened", "a file that exists and may be read");
    const std::streamoff size = stream.tellg();
    if (size < 0 || static_cast<std::size_t>(size) > limits.memory_bytes)
        throw ReadError(file, 0, "the file is too large, or no file",
                        fmt::format("at most {} MB", limits.memory_bytes >> 20));
    std::string content(static_cast<std::size_t>(size), '\0');
    stream.seekg(0);
    if (!stream.read(content.data(), size)) throw ReadError(file, 0, "cannot be read", "a file that may be read");
    return content;
}

}  // namespace

std::vector<UffDataset> read_uff(const std::string& file, const ReadLimits& limits) {
    Walker walker(file, read_whole(file, limits));
    std::vector<UffDataset> datasets;
    std::string_view line;
    bool any = false;
    while (walker.next(line)) {
        if (without_blanks(line) != "-1") {
            if (!without_blanks(line).empty() && !any) walker.fail("the file does not begin with the mark -1");
            continue;
        }
        any = true;
        if (!walker.next(line)) break;
        const std::string_view kind = without_blanks(line.substr(0, std::min<std::size_t>(line.size(), 7)));
        if (kind != "58" && kind != "58b" && kind != "58B") {  // another dataset: on to its end mark
            while (walker.next(line) && without_blanks(line) != "-1") {
            }
            continue;
        }
        const Binary binary = binary_header(walker, line);
        UffDataset dataset;
        dataset.line = walker.line_number();
        const Layout layout = read_records(walker, dataset);
        if (binary.is)
            read_binary_data(walker, binary, layout, dataset);
        else
            read_text_data(walker, layout, dataset);
        require_end_mark(walker);
        datasets.push_back(std::move(dataset));
    }
    if (datasets.empty())
        throw ReadError(file, 0, any ? "the file holds no dataset 58" : "the file is empty", uff_wanted);
    return datasets;
}

}  // namespace railpem::recordings

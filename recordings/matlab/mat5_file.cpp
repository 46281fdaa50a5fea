#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>

#include "recordings/files/read_error.hpp"
#include "recordings/files/text_encoding.hpp"
#include "recordings/matlab/mat_file.hpp"
#include "recordings/matlab/stored_numbers.hpp"

namespace railpem::recordings {
namespace {

constexpr std::uint64_t header_bytes = 128;
constexpr std::size_t most_dimensions = 32;

/// Types of the format (table 1-1) that occur as tags.
enum : std::uint32_t { tag_matrix = 14, tag_compressed = 15 };
/// Array classes (table 1-3).
enum : std::uint32_t {
    class_cell = 1,
    class_structure = 2,
    class_text = 4,
    class_sparse = 5,
    class_double = 6,
    class_uint64 = 15,
    class_opaque = 17
};

std::optional<NumberType> number_type(std::uint32_t tag) {
    switch (tag) {
        case 1:
            return NumberType::int8;
        case 2:
            return NumberType::uint8;
        case 3:
            return NumberType::int16;
        case 4:
            return NumberType::uint16;
        case 5:
            return NumberType::int32;
        case 6:
            return NumberType::uint32;
        case 7:
            return NumberType::single_float;
        case 9:
            return NumberType::double_float;
        case 12:
            return NumberType::int64;
        case 13:
            return NumberType::uint64;
        default:
            return std::nullopt;
    }
}

struct Tag {
    std::uint32_t type = 0;
    std::uint64_t data = 0, bytes = 0, end = 0;  ///< positions of its data and of what follows
};

/// One element of the file's top: where it lies, and whether it is deflated.
struct TopElement {
    std::uint64_t begin = 0, bytes = 0;
    bool deflated = false;
};

/// Reads the structure of one element, without the numbers.
class Mat5Walk {
  public:
    Mat5Walk(const std::string& file, bool swapped, ByteStream& stream, std::size_t stream_index,
             std::vector<StoredNumbers>& stored)
        : file_(file), swapped_(swapped), stream_(stream), stream_index_(stream_index), stored_(stored) {}

    MatVariable matrix(int level) {
        const Tag whole = tag();
        if (whole.type != tag_matrix) fail("an element is no matrix");
        MatVariable variable;
        if (whole.bytes > 0)
            variable = content(whole, level);
        else
            variable.value = {.kind = MatKind::numbers, .sizes = {0, 0}};
        stream_.seek(whole.end);
        return variable;
    }

  private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw ReadError(file_, 0, "the file is damaged: " + problem, "an undamaged file");
    }

    std::uint32_t word() {
        std::uint32_t value = 0;
        stream_.read(&value, sizeof value);
        return swapped_ ? swapped_bytes(value) : value;
    }

    /// A tag, in its long form or with its data inside (up to four bytes).
    Tag tag() {
        Tag result;
        const std::uint64_t at = stream_.position();
        const std::uint32_t first = word();
        if (first >> 16 != 0) {
            result = {first & 0xFFFFU, at + 4, first >> 16, at + 8};
            if (result.bytes > 4) fail("a small element of more than four bytes");
            return result;
        }
        const std::uint32_t bytes = word();
        return {first, at + 8, bytes, at + 8 + (std::uint64_t{bytes} + 7) / 8 * 8};
    }

    Tag within(const Tag& whole) {
        const Tag part = tag();
        if (part.data + part.bytes > whole.data + whole.bytes) fail("an element is longer than the one it is in");
        return part;
    }

    std::string text(const Tag& part) {
        if (part.bytes > longest_mat_name) fail("a name of more than 4096 letters");
        std::string letters(part.bytes, '\0');
        stream_.seek(part.data);
        stream_.read(letters.data(), letters.size());
        stream_.seek(part.end);
        bool converted = false;
        return to_utf8(letters.substr(0, letters.find('\0')), converted);
    }

    std::vector<std::size_t> sizes(const Tag& part) {
        if (part.bytes / 4 > most_dimensions) fail("a matrix of more than 32 dimensions");
        std::vector<std::size_t> result;
        std::size_t product = 1;
        for (std::uint64_t i = 0; i < part.bytes / 4; ++i) {
            result.push_back(word());
            if (result.back() > 0x7FFFFFFFU || __builtin_mul_overflow(product, result.back(), &product))
                fail("a matrix of a size that cannot be");
        }
        stream_.seek(part.end);
        return result;
    }

    MatVariable content(const Tag& whole, int level) {
        if (level > most_mat_levels || ++values_ > most_mat_values) fail("too many values within each other");
        const Tag flags = within(whole);
        if (flags.bytes != 8) fail("a matrix without its class");
        const std::uint32_t flag_word = word();
        stream_.seek(flags.end);
        const std::uint32_t kind = flag_word & 0xFFU;
        MatVariable variable;
        if (kind == class_opaque) {
            variable.name = text(within(whole));
            text(within(whole));  // the system of classes
            variable.value.class_name = text(within(whole));
            return variable;
        }
        variable.value.sizes = sizes(within(whole));
        variable.name = text(within(whole));
        fill(whole, kind, (flag_word & 0x800U) != 0, level, variable.value);
        return variable;
    }

    void fill(const Tag& whole, std::uint32_t kind, bool complex, int level, MatValue& value) {
        if (kind == class_cell) {
            value.kind = MatKind::cell;
            for (std::size_t i = 0, count = value.elements(); i < count; ++i)
                value.parts.push_back(matrix(level + 1).value);
        } else if (kind == class_structure) {
            value.kind = MatKind::structure;
            read_fields(whole, level, value);
        } else if (kind == class_text) {
            value.kind = MatKind::text;
        } else if (kind == class_sparse) {
            value.kind = MatKind::sparse;
        } else if (kind >= class_double && kind <= class_uint64) {
            value.kind = complex ? MatKind::complex : MatKind::numbers;
            if (!complex && value.elements() > 0) keep_numbers(within(whole), value);
        } else {
            value.class_name = kind == 16 ? "function_handle" : "object";
            value.sizes.clear();
        }
    }

    void read_fields(const Tag& whole, int level, MatValue& value) {
        const Tag length_tag = within(whole);
        const std::uint32_t length = word();
        stream_.seek(length_tag.end);
        const Tag names = within(whole);
        if (length == 0 || length > longest_mat_name || names.bytes > most_mat_values)
            fail("field names that cannot be");
        std::string letters(names.bytes, '\0');
        stream_.seek(names.data);
        stream_.read(letters.data(), letters.size());
        stream_.seek(names.end);
        for (std::size_t at = 0; at + length <= letters.size(); at += length)
            value.fields.push_back(letters.substr(at, std::min<std::size_t>(length, letters.find('\0', at) - at)));
        for (std::size_t i = 0, count = value.elements(); i < count; ++i)
            for (std::size_t f = 0; f < value.fields.size(); ++f) value.parts.push_back(matrix(level + 1).value);
    }

    void keep_numbers(const Tag& data, MatValue& value) {
        const std::optional<NumberType> type = number_type(data.type);
        if (!type) fail(fmt::format("numbers of the unknown type {}", data.type));
        value.stored = stored_.size();
        stored_.push_back({data.data, static_cast<std::size_t>(data.bytes / bytes_of(*type)), *type,
                           swapped_ != (std::endian::native == std::endian::big), stream_index_});
    }

    const std::string& file_;
    bool swapped_;
    ByteStream& stream_;
    std::size_t stream_index_;
    std::vector<StoredNumbers>& stored_;
    std::size_t values_ = 0;
};

class Mat5File : public MatFile {
  public:
    explicit Mat5File(const std::string& file) : file_(file) {
        const std::uint64_t size = std::filesystem::file_size(file);
        const auto whole = plain_bytes(file, 0, size);
        whole->seek(126);
        char mark = 0;
        whole->read(&mark, 1);
        const bool swapped = (mark == 'M') == (std::endian::native == std::endian::little);
        for (std::uint64_t at = header_bytes; at < size;) {
            whole->seek(at);
            std::uint32_t words[2] = {};
            if (size - at >= sizeof words) whole->read(words, sizeof words);
            if (swapped)
                for (std::uint32_t& word : words) word = swapped_bytes(word);
            const TopElement element{at, words[1], words[0] == tag_compressed};
            at += 8 + std::uint64_t{words[1]};
            if (at > size || words[0] == 0)
                throw ReadError(file, 0, "the file is truncated: its last variable is cut short",
                                "a complete .mat file");
            if (element.deflated || words[0] == tag_matrix) walk(element, swapped);
        }
    }

    void read(const std::vector<MatColumn>& channels, std::size_t begin, std::size_t count,
              std::vector<std::vector<double>>& columns) override {
        cursors_.resize(std::max(cursors_.size(), channels.size()));
        for (std::size_t i = 0; i < channels.size(); ++i) {
            const StoredNumbers& numbers = stored_[channels[i].stored];
            if (!cursors_[i].stream || cursors_[i].of != numbers.stream)
                cursors_[i] = {open(elements_[numbers.stream]), numbers.stream};
            append_numbers(*cursors_[i].stream, numbers, channels[i], begin, count, columns[i]);
        }
    }

  private:
    /// Where a channel is read at the moment: deflated bytes can only be read forwards.
    struct Cursor {
        std::unique_ptr<ByteStream> stream;
        std::size_t of = 0;
    };

    std::unique_ptr<ByteStream> open(const TopElement& element) const {
        return element.deflated ? inflated_bytes(file_, element.begin + 8, element.bytes)
                                : plain_bytes(file_, element.begin, 8 + element.bytes);
    }

    void walk(const TopElement& element, bool swapped) {
        const auto stream = open(element);
        elements_.push_back(element);
        Mat5Walk walk(file_, swapped, *stream, elements_.size() - 1, stored_);
        MatVariable variable = walk.matrix(0);
        require_counts(variable.value, variable.name);
        if (!variable.name.empty()) variables_.push_back(std::move(variable));
    }

    /// The numbers that a value announces must be there.
    void require_counts(const MatValue& value, const std::string& name) const {
        for (const MatValue& part : value.parts) require_counts(part, name);
        if (value.kind != MatKind::numbers || value.elements() == 0) return;
        if (stored_[value.stored].count < value.elements())
            throw ReadError(file_, 0,
                            fmt::format("the variable '{}' is cut short: {} of its {} numbers are there", name,
                                        stored_[value.stored].count, value.elements()),
                            "a complete .mat file");
    }

    std::string file_;
    std::vector<TopElement> elements_;
    std::vector<StoredNumbers> stored_;
    std::vector<Cursor> cursors_;
};

}  // namespace

std::unique_ptr<MatFile> open_mat5(const std::string& file) {
    return std::make_unique<Mat5File>(file);
}

}  // namespace railpem::recordings

#include <fmt/format.h>

#include <bit>
#include <filesystem>

#include "recordings/files/read_error.hpp"
#include "recordings/matlab/mat_file.hpp"
#include "recordings/matlab/stored_numbers.hpp"

namespace railpem::recordings {
namespace {

/// The five numbers in front of every matrix.
struct Mat4Header {
    std::uint32_t type = 0, rows = 0, columns = 0, imaginary = 0, name_bytes = 0;
};

class Mat4File : public MatFile {
  public:
    explicit Mat4File(const std::string& file) : file_(file), size_(std::filesystem::file_size(file)) {
        stream_ = plain_bytes(file, 0, size_);
        while (stream_->position() < size_) add_matrix();
    }

    void read(const std::vector<MatColumn>& channels, std::size_t begin, std::size_t count,
              std::vector<std::vector<double>>& columns) override {
        for (std::size_t i = 0; i < channels.size(); ++i)
            append_numbers(*stream_, stored_[channels[i].stored], channels[i], begin, count, columns[i]);
    }

  private:
    [[noreturn]] void fail_kind() const {
        throw ReadError(file_, 0, "not a MATLAB file, or a damaged one", "a .mat file of version 4, 5, 7 or 7.3");
    }

    void add_matrix() {
        Mat4Header header;
        if (size_ - stream_->position() < sizeof header) fail_kind();
        stream_->read(&header, sizeof header);
        // The type is less than 5000 in the order of bytes in which the file was written.
        const bool swapped = header.type > 9999;
        if (swapped)
            for (std::uint32_t* word :
                 {&header.type, &header.rows, &header.columns, &header.imaginary, &header.name_bytes})
                *word = swapped_bytes(*word);
        static const NumberType types[] = {NumberType::double_float, NumberType::single_float, NumberType::int32,
                                           NumberType::int16,        NumberType::uint16,       NumberType::uint8};
        const std::uint32_t machine = header.type / 1000, precision = header.type / 10 % 10, kind = header.type % 10;
        if (machine > 1 || header.type / 100 % 10 != 0 || precision > 5 || kind > 2 || header.imaginary > 1 ||
            header.name_bytes == 0 || header.name_bytes > longest_mat_name)
            fail_kind();
        std::string name(header.name_bytes, '\0');
        stream_->read(name.data(), name.size());
        MatVariable variable{name.substr(0, name.find('\0')), {}};
        variable.value.sizes = {header.rows, header.columns};
        variable.value.kind = kind == 1               ? MatKind::text
                              : kind == 2             ? MatKind::sparse
                              : header.imaginary == 1 ? MatKind::complex
                                                      : MatKind::numbers;
        keep(variable.value, types[precision], swapped, header.imaginary + 1, variable.name);
        variables_.push_back(std::move(variable));
    }

    void keep(MatValue& value, NumberType type, bool swapped, std::size_t parts, const std::string& name) {
        const std::uint64_t left = (size_ - stream_->position()) / bytes_of(type);
        if (value.sizes[1] > 0 && value.sizes[0] > left / parts / value.sizes[1])
            throw ReadError(file_, 0,
                            fmt::format("the variable '{}' is cut short: {} of its {} x {} numbers are there", name,
                                        left, value.sizes[0], value.sizes[1]),
                            "a complete .mat file");
        value.stored = stored_.size();
        stored_.push_back({stream_->position(), value.elements(), type, swapped, 0});
        stream_->seek(stream_->position() + parts * value.elements() * bytes_of(type));
    }

    std::string file_;
    std::uint64_t size_;
    std::unique_ptr<ByteStream> stream_;
    std::vector<StoredNumbers> stored_;
};

}  // namespace

std::unique_ptr<MatFile> open_mat4(const std::string& file) {
    return std::make_unique<Mat4File>(file);
}

}  // namespace railpem::recordings

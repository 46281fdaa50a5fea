#include <fmt/format.h>
#include <matio.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>

#include "recordings/files/isolated_read.hpp"
#include "recordings/files/named_column.hpp"
#include "recordings/files/read_binary.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/read_unprotected.hpp"

namespace railpem::recordings {
namespace {

struct CloseMat {
    void operator()(mat_t* mat) const { Mat_Close(mat); }
};
struct FreeVariable {
    void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

template <class Number>
void append(const matvar_t& variable, std::size_t begin, std::size_t count, std::vector<double>& values) {
    const auto* data = static_cast<const Number*>(variable.data) + begin;
    for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<double>(data[i]));
}

bool is_numeric(const matvar_t& variable) {
    return variable.class_type >= MAT_C_DOUBLE && variable.class_type <= MAT_C_UINT64 && variable.rank == 2 &&
           variable.dims && !variable.isComplex;
}

/// `count` values of the variable from index `begin`, column by column as MATLAB stores them.
std::vector<double> values_of(const matvar_t& variable, std::size_t begin, std::size_t count) {
    std::vector<double> values;
    values.reserve(count);
    switch (variable.data_type) {
        case MAT_T_DOUBLE:
            append<double>(variable, begin, count, values);
            break;
        case MAT_T_SINGLE:
            append<float>(variable, begin, count, values);
            break;
        case MAT_T_INT8:
            append<std::int8_t>(variable, begin, count, values);
            break;
        case MAT_T_UINT8:
            append<std::uint8_t>(variable, begin, count, values);
            break;
        case MAT_T_INT16:
            append<std::int16_t>(variable, begin, count, values);
            break;
        case MAT_T_UINT16:
            append<std::uint16_t>(variable, begin, count, values);
            break;
        case MAT_T_INT32:
            append<std::int32_t>(variable, begin, count, values);
            break;
        case MAT_T_UINT32:
            append<std::uint32_t>(variable, begin, count, values);
            break;
        case MAT_T_INT64:
            append<std::int64_t>(variable, begin, count, values);
            break;
        case MAT_T_UINT64:
            append<std::uint64_t>(variable, begin, count, values);
            break;
        default:
            break;
    }
    return values;
}

/// Names of the numeric variables, fields of (scalar) structures included.
void list_names(const matvar_t& variable, const std::string& name, std::vector<std::string>& names) {
    if (is_numeric(variable)) {
        names.push_back(name);
    } else if (variable.class_type == MAT_C_STRUCT) {
        const unsigned fields = Mat_VarGetNumberOfFields(const_cast<matvar_t*>(&variable));
        char* const* field_names = Mat_VarGetStructFieldnames(&variable);
        for (unsigned i = 0; i < fields && field_names; ++i)
            if (const matvar_t* field = Mat_VarGetStructFieldByIndex(const_cast<matvar_t*>(&variable), i, 0))
                list_names(*field, name + "." + field_names[i], names);
    }
}

class MatFile {
  public:
    MatFile(const std::string& file, const ReadLimits& limits)
        : file_(file), limits_(limits), mat_(Mat_Open(file.c_str(), MAT_ACC_RDONLY)) {
        if (!mat_)
            throw ReadError(file, 0, "not a MATLAB file, or a damaged one", "a .mat file of version 4, 5, 7 or 7.3");
        while (const Variable variable{Mat_VarReadNextInfo(mat_.get())})
            if (variable->name) list_names(*variable, variable->name, names_);
        if (names_.empty())
            throw ReadError(file, 0, "the file holds no real matrix", "real numeric vectors or matrices");
    }

    const std::vector<std::string>& names() const { return names_; }

    /// The numeric variable `name`, read in full. Structures are read as a whole, once.
    const matvar_t& variable(const std::string& name) {
        require_name(name, names_, "variable", file_, 0);
        const std::string root = name.substr(0, name.find('.'));
        if (!root_ || root != root_->name) {
            Mat_Rewind(mat_.get());
            Variable info{Mat_VarReadInfo(mat_.get(), root.c_str())};
            if (info && Mat_VarGetSize(info.get()) > limits_.memory_bytes)
                throw ReadError(file_, 0, fmt::format("the variable '{}' is too large", root),
                                fmt::format("at most {} MB of numbers", limits_.memory_bytes >> 20));
            Mat_Rewind(mat_.get());
            root_.reset(Mat_VarRead(mat_.get(), root.c_str()));
        }
        matvar_t* found = root_.get();
        for (std::size_t dot = name.find('.'); found && dot != std::string::npos;) {
            const std::size_t next = name.find('.', dot + 1);
            found = Mat_VarGetStructFieldByName(
                found, name.substr(dot + 1, next == std::string::npos ? next : next - dot - 1).c_str(), 0);
            dot = next;
        }
        if (!found || !is_numeric(*found) || !found->data)
            throw ReadError(file_, 0, fmt::format("the variable '{}' cannot be read", name), "an undamaged file");
        const std::size_t rows = found->dims[0], columns = found->dims[1];
        if (rows > 0 && (columns > found->nbytes / rows ||
                         rows * columns * static_cast<std::size_t>(found->data_size) > found->nbytes))
            throw ReadError(file_, 0, fmt::format("the variable '{}' is shorter than it says", name),
                            "an undamaged file");
        return *found;
    }

  private:
    std::string file_;
    ReadLimits limits_;
    std::unique_ptr<mat_t, CloseMat> mat_;
    std::vector<std::string> names_;
    Variable root_;
};

/// Walks the elements of a version 5 file. The library takes a variable that the file cuts short for a whole one, the
/// rest left as it comes; whether the file holds what its elements announce is therefore checked here.
void require_complete(const std::string& file) {
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    const std::streamoff size = in ? static_cast<std::streamoff>(in.tellg()) : 0;
    char header[128] = {};
    in.seekg(0);
    if (size < 128 || !in.read(header, sizeof header) || std::strncmp(header, "MATLAB 5.0", 10) != 0)
        return;                               // 4 and 7.3 are told by the library
    const bool swapped = header[126] == 'M';  // written "MI" as one number: bytes in the other order read "MI"
    const auto word = [&](const unsigned char* b) {
        return swapped ? std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | b[3]
                       : std::uint32_t{b[3]} << 24 | std::uint32_t{b[2]} << 16 | std::uint32_t{b[1]} << 8 | b[0];
    };
    for (std::streamoff at = 128; at < size;) {
        unsigned char tag[8];
        in.seekg(at);
        const bool whole = static_cast<bool>(in.read(reinterpret_cast<char*>(tag), sizeof tag));
        at += 8 + (whole ? static_cast<std::streamoff>(word(tag + 4)) : 0);
        if (!whole || at > size)
            throw ReadError(file, 0, "the file is truncated: its last variable is cut short", "a complete .mat file");
    }
}

void append_columns(const matvar_t& variable, const std::string& name, std::size_t column, const std::string& file,
                    DataTable& table) {
    const std::size_t rows = variable.dims[0], columns = variable.dims[1];
    const bool vector = rows == 1 || columns == 1;
    if (column > 0 && column > columns)
        throw ReadError(file, 0, fmt::format("the variable '{}' has no column {}", name, column),
                        fmt::format("1 to {}", columns));
    if (vector && column == 0) {
        table.names.push_back(name);
        table.columns.push_back(values_of(variable, 0, rows * columns));
        return;
    }
    for (std::size_t i = column > 0 ? column - 1 : 0; i < (column > 0 ? column : columns); ++i) {
        table.names.push_back(fmt::format("{}:{}", name, i + 1));
        table.columns.push_back(values_of(variable, i * rows, rows));
    }
}

}  // namespace

DataTable read_mat_unprotected(const std::string& file, const std::vector<std::string>& wanted,
                               const ReadLimits& limits) {
    require_complete(file);
    Mat_LogInit("railpem");
    MatFile mat(file, limits);
    DataTable table;
    for (const std::string& text : wanted.empty() ? mat.names() : wanted) {
        const NamedColumn name = named_column(text);
        const std::size_t before = table.columns.size();
        const matvar_t& variable = mat.variable(name.name);
        if (wanted.empty() && variable.dims[0] * variable.dims[1] <= 1) continue;  // settings beside the data
        append_columns(variable, name.name, name.column, file, table);
        if (!wanted.empty() && table.columns.size() != before + 1)
            throw ReadError(file, 0,
                            fmt::format("the variable '{}' is a matrix of {} columns", name.name, variable.dims[1]),
                            fmt::format("{0}:1 to {0}:{1}", name.name, variable.dims[1]));
        if (!wanted.empty()) table.names.back() = text;
    }
    return table;
}

DataTable read_mat(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits) {
    return read_isolated(file, limits, [&] { return read_mat_unprotected(file, wanted, limits); });
}

}  // namespace railpem::recordings

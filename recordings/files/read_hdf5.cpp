#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <array>

#include "recordings/files/isolated_read.hpp"
#include "recordings/files/named_column.hpp"
#include "recordings/files/read_binary.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/read_unprotected.hpp"

namespace railpem::recordings {
namespace {

/// An HDF5 identifier and how it is given back.
class Handle {
  public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    operator hid_t() const { return id_; }  // NOLINT: the C interface takes it everywhere
    bool valid() const { return id_ >= 0; }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

struct Shape {
    std::size_t rows = 0;     ///< samples
    std::size_t columns = 1;  ///< channels
    bool one_dimensional = true;
    bool channels_first = false;  ///< stored [channel][sample]
};

/// Shape of a numeric dataset of one or two dimensions; false for anything else.
bool shape_of(hid_t dataset, Shape& shape) {
    const Handle type(H5Dget_type(dataset), H5Tclose);
    const H5T_class_t kind = type.valid() ? H5Tget_class(type) : H5T_NO_CLASS;
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) return false;
    const Handle space(H5Dget_space(dataset), H5Sclose);
    const int rank = space.valid() ? H5Sget_simple_extent_ndims(space) : -1;
    std::array<hsize_t, 2> sizes{};
    if (rank < 1 || rank > 2 || H5Sget_simple_extent_dims(space, sizes.data(), nullptr) != rank) return false;
    shape.one_dimensional = rank == 1;
    shape.rows = sizes[0];
    if (rank == 2) {
        shape.channels_first = sizes[0] < sizes[1];
        shape.rows = std::max(sizes[0], sizes[1]);
        shape.columns = std::min(sizes[0], sizes[1]);
    }
    return shape.rows > 0 && shape.columns > 0;
}

extern "C" herr_t collect_dataset(hid_t, const char* name, const H5O_info_t* info, void* names) {
    if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
}

double rate_attribute(hid_t object) {
    if (H5Aexists(object, "sampling_rate_hz") <= 0) return 0.0;
    const Handle attribute(H5Aopen(object, "sampling_rate_hz", H5P_DEFAULT), H5Aclose);
    const Handle space(attribute.valid() ? H5Aget_space(attribute) : -1, H5Sclose);
    double rate = 0.0;
    if (!space.valid() || H5Sget_simple_extent_npoints(space) != 1 || H5Aread(attribute, H5T_NATIVE_DOUBLE, &rate) < 0)
        return 0.0;
    return rate;
}

/// One column of the dataset (from 0).
std::vector<double> read_column(const std::string& file, const std::string& name, hid_t dataset, const Shape& shape,
                                std::size_t column) {
    std::vector<double> values(shape.rows);
    const Handle space(H5Dget_space(dataset), H5Sclose);
    const hsize_t count_all = shape.rows;
    const Handle memory(H5Screate_simple(1, &count_all, nullptr), H5Sclose);
    if (!shape.one_dimensional) {
        std::array<hsize_t, 2> start = {0, column}, count = {shape.rows, 1};
        if (shape.channels_first) {
            start = {column, 0};
            count = {1, shape.rows};
        }
        H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    }
    if (H5Dread(dataset, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()) < 0)
        throw ReadError(file, 0, fmt::format("the dataset '{}' cannot be read", name), "an undamaged file");
    return values;
}

}  // namespace

DataTable read_hdf5_unprotected(const std::string& file, const std::vector<std::string>& wanted,
                                const ReadLimits& limits) {
    H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
    const Handle root(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!root.valid()) throw ReadError(file, 0, "not an HDF5 file, or a damaged one", "an HDF5 file");
    std::vector<std::string> names;
    if (H5Ovisit(root, H5_INDEX_NAME, H5_ITER_NATIVE, collect_dataset, &names) < 0 || names.empty())
        throw ReadError(file, 0, "no dataset is found in the file", "numeric datasets of one or two dimensions");
    DataTable table;
    table.sampling_rate_hz = rate_attribute(root);
    std::size_t bytes = 0;
    for (const std::string& text : wanted.empty() ? names : wanted) {
        NamedColumn name = named_column(text);
        if (!name.name.empty() && name.name.front() == '/') name.name.erase(0, 1);
        require_name(name.name, names, "dataset", file, 0);
        const Handle dataset(H5Dopen2(root, name.name.c_str(), H5P_DEFAULT), H5Dclose);
        Shape shape;
        if (!dataset.valid() || !shape_of(dataset, shape)) {
            if (wanted.empty()) continue;
            throw ReadError(file, 0, fmt::format("the dataset '{}' is not one of real numbers", name.name),
                            "a numeric dataset of one or two dimensions");
        }
        if (table.sampling_rate_hz <= 0.0) table.sampling_rate_hz = rate_attribute(dataset);
        if (name.column > shape.columns || (!wanted.empty() && name.column == 0 && shape.columns > 1))
            throw ReadError(
                file, 0,
                fmt::format("the dataset '{}' has {} columns, '{}' does not name one", name.name, shape.columns, text),
                fmt::format("{0}:1 to {0}:{1}", name.name, shape.columns));
        const std::size_t first = name.column > 0 ? name.column - 1 : 0;
        for (std::size_t i = first; i < (name.column > 0 ? name.column : shape.columns); ++i) {
            bytes += shape.rows * sizeof(double);
            if (bytes > limits.memory_bytes || table.names.size() >= limits.columns)
                throw ReadError(file, 0, "too many numbers to hold at once",
                                fmt::format("at most {} MB", limits.memory_bytes >> 20));
            table.names.push_back(!wanted.empty()     ? text
                                  : shape.columns > 1 ? fmt::format("{}:{}", name.name, i + 1)
                                                      : name.name);
            table.columns.push_back(read_column(file, name.name, dataset, shape, i));
        }
    }
    return table;
}

DataTable read_hdf5(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits) {
    return read_isolated(file, limits, [&] { return read_hdf5_unprotected(file, wanted, limits); });
}

}  // namespace railpem::recordings

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "recordings/files/hdf5_channels.hpp"
#include "recordings/files/hdf5_statement.hpp"
#include "recordings/files/named_column.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/read_unprotected.hpp"
#include "recordings/files/send_blocks.hpp"
#include "recordings/files/text_encoding.hpp"

namespace railpem::recordings {
namespace {

struct Shape {
    std::size_t rows = 0;     ///< samples
    std::size_t columns = 1;  ///< channels
    int sample_axis = 0;
    int channel_axis = -1;  ///< -1: one dimension
};

/// Shape of a numeric dataset of one or two dimensions; nothing for any other.
std::optional<Shape> shape_of(hid_t dataset) {
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    const H5T_class_t kind = type.valid() ? H5Tget_class(type) : H5T_NO_CLASS;
    const std::vector<hsize_t> sizes = extents_of(dataset);
    if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || sizes.empty() || sizes.size() > 2) return std::nullopt;
    Shape shape{sizes[0]};
    if (sizes.size() == 2) {
        shape.sample_axis = sizes[0] < sizes[1] ? 1 : 0;
        shape.channel_axis = 1 - shape.sample_axis;
        shape.rows = std::max(sizes[0], sizes[1]);
        shape.columns = std::min(sizes[0], sizes[1]);
    }
    return shape.rows > 0 && shape.columns > 0 ? std::optional(shape) : std::nullopt;
}

/// Why a dataset is no channel.
std::string what_it_is(hid_t dataset) {
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    const H5T_class_t kind = type.valid() ? H5Tget_class(type) : H5T_NO_CLASS;
    const std::vector<hsize_t> sizes = extents_of(dataset);
    if (kind == H5T_STRING) return "text";
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) return "not one of real numbers";
    if (sizes.empty()) return "a single number, no samples";
    return std::count(sizes.begin(), sizes.end(), 0U) > 0
               ? fmt::format("empty ({})", fmt::join(sizes, " x "))
               : fmt::format("of {} dimensions ({})", sizes.size(), fmt::join(sizes, " x "));
}

/// Names as they stand in the file, and as UTF-8, which descriptions and messages are.
struct Names {
    std::vector<std::string> stored, shown;
    std::vector<std::string> outside;  ///< links that lead into other files
};

extern "C" herr_t collect_dataset(hid_t, const char* name, const H5O_info_t* info, void* names) {
    if (info->type == H5O_TYPE_DATASET) static_cast<Names*>(names)->stored.emplace_back(name);
    return 0;
}

extern "C" herr_t collect_external(hid_t, const char* name, const H5L_info_t* info, void* names) {
    if (info->type == H5L_TYPE_EXTERNAL) static_cast<Names*>(names)->outside.emplace_back(name);
    return 0;
}

Names names_of(hid_t root) {
    Names names;
    H5Ovisit(root, H5_INDEX_NAME, H5_ITER_NATIVE, collect_dataset, &names);
    H5Lvisit(root, H5_INDEX_NAME, H5_ITER_NATIVE, collect_external, &names);
    bool converted = false;
    for (const std::string& name : names.stored) names.shown.push_back(to_utf8(name, converted));
    for (std::string& name : names.outside) name = to_utf8(name, converted);
    return names;
}

/// Reads the channels of one file: each is looked up, then all are read by blocks.
class Hdf5File {
  public:
    Hdf5File(const std::string& file, bool all) : file_(file), all_(all), root_(open_hdf5(file)), channels_(file) {
        if (!root_.valid()) throw ReadError(file, 0, "not an HDF5 file, or a damaged one", "an HDF5 file");
        names_ = names_of(root_);
        if (names_.stored.empty())
            throw ReadError(file, 0, "no dataset is found in the file", "numeric datasets of one or two dimensions");
        take_rate(root_);
    }

    const std::vector<std::string>& names() const { return names_.shown; }
    std::size_t length() const { return length_; }

    void add(const std::string& text) {
        NamedColumn name = named_column(text);
        if (!name.name.empty() && name.name.front() == '/') name.name.erase(0, 1);
        const std::optional<Shape> shape = open(name.name);
        if (!shape) return;
        if (name.column > shape->columns || (!all_ && name.column == 0 && shape->columns > 1))
            throw ReadError(
                file_, 0,
                fmt::format("the dataset '{}' has {} columns, '{}' does not name one", name.name, shape->columns, text),
                fmt::format("{0}:1 to {0}:{1}", name.name, shape->columns));
        const std::size_t first = name.column > 0 ? name.column - 1 : 0;
        for (std::size_t i = first; i < (name.column > 0 ? name.column : shape->columns); ++i)
            add_channel(!all_                ? text
                        : shape->columns > 1 ? fmt::format("{}:{}", name.name, i + 1)
                                             : name.name,
                        names_.stored[require_name(name.name, names_.shown, "dataset", file_, 0)], *shape, i);
    }

    void read(std::size_t begin, std::size_t count) {
        channels_.read(begin, count, table.columns);
        for (std::size_t i = 0; i < missing_.size(); ++i)
            for (const double missing : missing_[i])
                std::replace(table.columns[i].begin(), table.columns[i].end(), missing,
                             std::numeric_limits<double>::quiet_NaN());
    }

    DataTable table;

  private:
    void require_own(const std::string& name) const {
        for (const std::string& link : names_.outside)
            if (name == link || name.starts_with(link + "/"))
                throw ReadError(file_, 0, fmt::format("'{}' is a link into another file", link),
                                "a file that holds its numbers itself");
    }

    /// Makes the dataset the last of the source, unless it is already. Nothing when all are read and it is no channel.
    std::optional<Shape> open(const std::string& name) {
        require_own(name);
        const std::string& stored = names_.stored[require_name(name, names_.shown, "dataset", file_, 0)];
        if (opened_.contains(stored)) {
            last_ = opened_[stored].second;
            return opened_[stored].first;
        }
        Hdf5Handle dataset(H5Dopen2(root_, stored.c_str(), H5P_DEFAULT), H5Dclose);
        const std::optional<Shape> shape = dataset.valid() ? shape_of(dataset) : std::nullopt;
        if (!shape && all_) return std::nullopt;
        if (!shape)
            throw ReadError(
                file_, 0,
                fmt::format("the dataset '{}' is {}", name, dataset.valid() ? what_it_is(dataset) : "damaged"),
                "a numeric dataset of one or two dimensions");
        const Hdf5Handle group = group_of(stored);
        take_rate(dataset);
        if (group.valid()) take_rate(group);
        for (std::size_t i = 0; i < shape->columns; ++i)
            statements_[stored].push_back(hdf5_statement(dataset, group, i));
        fill_values_[stored] = hdf5_fill_values(dataset);
        if (const std::vector<std::string> unused = hdf5_unused_scales(dataset); !unused.empty())
            table.notes.push_back(
                fmt::format("the dataset '{}' has the attributes {}, which are not applied: "
                            "scale_factor in the description does",
                            name, fmt::join(unused, ", ")));
        last_ = channels_.add_dataset(std::move(dataset), name);
        opened_[stored] = {*shape, last_};
        return shape;
    }

    /// The group that a dataset has for itself, in the manner of TDMS; none for one that lies at the top.
    Hdf5Handle group_of(const std::string& stored) const {
        const std::size_t slash = stored.rfind('/');
        if (slash == std::string::npos) return {-1, H5Oclose};
        return {H5Oopen(root_, stored.substr(0, slash).c_str(), H5P_DEFAULT), H5Oclose};
    }

    void take_rate(hid_t object) {
        if (table.sampling_rate_hz > 0.0) return;
        const std::optional<StatedRate> rate = hdf5_rate(object);
        if (!rate) return;
        table.sampling_rate_hz = rate->hz;
        table.says.sampling_rate_where = rate->where;
    }

    void add_channel(const std::string& name, const std::string& stored, const Shape& shape, std::size_t column) {
        if (table.names.empty()) length_ = shape.rows;
        if (shape.rows != length_)
            throw ReadError(
                file_, 0,
                fmt::format("'{}' has {} samples and '{}' has {}", table.names.front(), length_, name, shape.rows),
                "channels of one length");
        table.names.push_back(name);
        table.says.columns.push_back(statements_[stored][column]);
        missing_.push_back(fill_values_[stored]);
        channels_.add({last_, shape.sample_axis, shape.channel_axis, column});
    }

    std::string file_;
    bool all_;
    Hdf5Handle root_;
    Names names_;
    Hdf5Channels channels_;
    std::map<std::string, std::pair<Shape, std::size_t>> opened_;
    std::map<std::string, std::vector<ColumnStatement>> statements_;
    std::map<std::string, std::vector<double>> fill_values_;
    std::vector<std::vector<double>> missing_;  ///< of each channel
    std::size_t last_ = 0, length_ = 0;
};

}  // namespace

void read_hdf5_unprotected(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                           const ReadLimits& limits, const SendTable& send) {
    H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
    Hdf5File source(file, wanted.empty());
    for (const std::string& name : wanted.empty() ? source.names() : wanted) source.add(name);
    send_blocks(source.table, source.length(), rows, limits, file, send,
                [&](std::size_t begin, std::size_t count) { source.read(begin, count); });
}

}  // namespace railpem::recordings

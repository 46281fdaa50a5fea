#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "recordings/files/hdf5_attribute.hpp"
#include "recordings/files/hdf5_channels.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/text_encoding.hpp"
#include "recordings/matlab/mat_file.hpp"

namespace railpem::recordings {
namespace {

extern "C" herr_t collect_hard_link(hid_t, const char* name, const H5L_info_t* info, void* names) {
    if (info->type == H5L_TYPE_HARD) static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
}

std::vector<std::string> members_of(hid_t group) {
    std::vector<std::string> names;
    H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect_hard_link, &names);
    return names;
}

Hdf5Handle open_object(hid_t place, const std::string& name) {
    return {H5Oopen(place, name.c_str(), H5P_DEFAULT), H5Oclose};
}

H5T_class_t type_of(hid_t dataset) {
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    return type.valid() ? H5Tget_class(type) : H5T_NO_CLASS;
}

/// MATLAB counts the sizes from the other end, and has at least two.
std::vector<std::size_t> matlab_sizes(hid_t dataset) {
    const std::vector<hsize_t> extents = extents_of(dataset);
    std::vector<std::size_t> sizes(extents.rbegin(), extents.rend());
    while (sizes.size() < 2) sizes.push_back(1);
    return sizes;
}

bool is_number_class(const std::string& name) {
    static const char* const all[] = {"",      "double", "single", "logical", "int8",  "uint8",
                                      "int16", "uint16", "int32",  "uint32",  "int64", "uint64"};
    return std::find(std::begin(all), std::end(all), name) != std::end(all);
}

class Mat73File : public MatFile {
  public:
    explicit Mat73File(const std::string& file) : file_(file), root_(open_hdf5(file)) {
        if (!root_.valid()) throw ReadError(file, 0, "not a MATLAB file, or a damaged one", "a .mat file");
        for (const std::string& name : members_of(root_)) {
            if (name.starts_with('#')) continue;  // what references lead to, and the store of objects
            const Hdf5Handle object = open_object(root_, name);
            bool converted = false;
            if (object.valid()) variables_.push_back({to_utf8(name, converted), value_of(object, 0)});
        }
    }

    void read(const std::vector<MatColumn>& channels, std::size_t begin, std::size_t count,
              std::vector<std::vector<double>>& columns) override {
        Hdf5Channels source(file_);
        for (std::size_t i = 0; i < channels.size(); ++i) {
            const bool same = i > 0 && channels[i].stored == channels[i - 1].stored;
            if (!same) dataset_ = source.add_dataset(open_stored(channels[i].stored), fmt::format("{}", i + 1));
            source.add(place_of(channels[i], dataset_));
        }
        source.read(begin, count, columns);
    }

  private:
    Hdf5Handle open_stored(std::size_t stored) const { return {H5Oopen_by_addr(root_, addresses_[stored]), H5Oclose}; }

    /// The axes of a channel: HDF5 counts them from the side that MATLAB calls last.
    Hdf5Channel place_of(const MatColumn& channel, std::size_t dataset) const {
        const std::vector<hsize_t> extents = extents_of(open_stored(channel.stored));
        std::vector<int> longer;
        for (std::size_t axis = 0; axis < extents.size(); ++axis)
            if (extents[axis] != 1) longer.push_back(static_cast<int>(axis));
        if (longer.size() < 2) return {dataset, longer.empty() ? 0 : longer.front(), -1, 0};
        if (channel.step == 1) return {dataset, longer[1], longer[0], channel.first / channel.count};
        return {dataset, longer[0], longer[1], channel.first};
    }

    MatValue value_of(hid_t object, int level) {
        if (level > most_mat_levels || ++values_ > most_mat_values)
            throw ReadError(file_, 0, "too many values within each other", "a file of fewer values");
        const std::string name = text_attribute(object, "MATLAB_class").value_or("");
        if (H5Iget_type(object) == H5I_GROUP) return group_value(object, name, level);
        if (H5Iget_type(object) == H5I_DATASET) return dataset_value(object, name, level);
        return {.class_name = "of another program"};
    }

    MatValue group_value(hid_t group, const std::string& name, int level) {
        if (H5Aexists(group, "MATLAB_sparse") > 0) return {.kind = MatKind::sparse, .sizes = {1, 1}};
        if (!name.empty() && name != "struct") return {.class_name = name};
        MatValue value{.kind = MatKind::structure, .sizes = {1, 1}};
        const std::vector<std::string> members = members_of(group);
        std::vector<Hdf5Handle> objects;
        bool array = !members.empty();
        for (const std::string& member : members) {
            objects.push_back(open_object(group, member));
            bool converted = false;
            value.fields.push_back(to_utf8(member, converted));
            array = array && objects.back().valid() && is_element_list(objects.back());
        }
        if (array) return structure_array(objects, std::move(value), level);
        for (const Hdf5Handle& object : objects)
            value.parts.push_back(object.valid() ? value_of(object, level + 1) : MatValue{.class_name = "unknown"});
        return value;
    }

    /// A field of an array of structures: references to the elements' values, without a class of its own.
    static bool is_element_list(hid_t object) {
        return H5Iget_type(object) == H5I_DATASET && type_of(object) == H5T_REFERENCE &&
               H5Aexists(object, "MATLAB_class") <= 0;
    }

    MatValue structure_array(const std::vector<Hdf5Handle>& fields, MatValue value, int level) {
        value.sizes = matlab_sizes(fields.front());
        std::vector<std::vector<MatValue>> columns;
        for (const Hdf5Handle& field : fields) {
            columns.push_back(referenced(field, level));
            if (columns.back().size() != columns.front().size())
                throw ReadError(file_, 0, "the fields of an array of structures differ in number", "an undamaged file");
        }
        for (std::size_t i = 0; i < columns.front().size(); ++i)
            for (std::vector<MatValue>& column : columns) value.parts.push_back(std::move(column[i]));
        return value;
    }

    /// What the references of a dataset lead to.
    std::vector<MatValue> referenced(hid_t dataset, int level) {
        const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
        const hssize_t count = space.valid() ? H5Sget_simple_extent_npoints(space) : 0;
        if (count < 0 || static_cast<std::size_t>(count) > most_mat_values)
            throw ReadError(file_, 0, "too many values within each other", "a file of fewer values");
        require_readable(dataset, "of references", file_);
        std::vector<hobj_ref_t> references(static_cast<std::size_t>(count));
        if (count > 0 && H5Dread(dataset, H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data()) < 0)
            throw ReadError(file_, 0, "a list of references cannot be read", "an undamaged file");
        std::vector<MatValue> values;
        for (const hobj_ref_t& reference : references) {
            const Hdf5Handle object(H5Rdereference2(dataset, H5P_DEFAULT, H5R_OBJECT, &reference), H5Oclose);
            values.push_back(object.valid() ? value_of(object, level + 1)
                                            : MatValue{.kind = MatKind::numbers, .sizes = {0, 0}});
        }
        return values;
    }

    MatValue dataset_value(hid_t dataset, const std::string& name, int level) {
        const H5T_class_t type = type_of(dataset);
        MatValue value{.sizes = matlab_sizes(dataset)};
        const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
        const bool empty = number_attribute(dataset, "MATLAB_empty").value_or(0.0) != 0.0 ||
                           H5Sget_simple_extent_type(space) == H5S_NULL;
        if (empty) value.sizes = {0, 0};
        if (name == "char" || type == H5T_STRING) {
            value.kind = MatKind::text;
        } else if (name == "struct" && empty) {
            value.kind = MatKind::structure;
        } else if (type == H5T_REFERENCE || (name == "cell" && empty)) {
            value.kind = MatKind::cell;
            if (!empty) value.parts = referenced(dataset, level);
        } else if (type == H5T_COMPOUND && is_number_class(name)) {
            value.kind = MatKind::complex;
        } else if ((type == H5T_INTEGER || type == H5T_FLOAT) && is_number_class(name)) {
            value.kind = MatKind::numbers;
            if (value.elements() > 0) keep(dataset, value);
        } else {
            value = {.class_name = name.empty() ? "unknown" : name};
        }
        return value;
    }

    void keep(hid_t dataset, MatValue& value) {
        H5O_info_t info{};
        if (H5Oget_info(dataset, &info) < 0) throw ReadError(file_, 0, "a value cannot be read", "an undamaged file");
        value.stored = addresses_.size();
        addresses_.push_back(info.addr);
    }

    std::string file_;
    Hdf5Handle root_;
    std::vector<haddr_t> addresses_;
    std::size_t values_ = 0, dataset_ = 0;
};

}  // namespace

std::unique_ptr<MatFile> open_mat73(const std::string& file) {
    H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
    return std::make_unique<Mat73File>(file);
}

}  // namespace railpem::recordings

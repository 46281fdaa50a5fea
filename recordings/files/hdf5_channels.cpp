#include "recordings/files/hdf5_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "recordings/files/read_error.hpp"
#include "recordings/files/text_encoding.hpp"

namespace railpem::recordings {
namespace {

constexpr hsize_t numbers_at_once = 1U << 17;

std::string shown(const std::string& text) {
    bool converted = false;
    return to_utf8(text, converted);
}

void refuse_outside(const std::string& file, const std::string& name, const std::string& other) {
    throw ReadError(file, 0,
                    fmt::format("the dataset '{}' keeps its numbers in another file, '{}'", name, shown(other)),
                    "a file that holds its numbers itself (h5repack writes one)");
}

void require_own_numbers(hid_t creation, const std::string& name, const std::string& file) {
    std::array<char, 256> other{};
    if (H5Pget_external_count(creation) > 0) {
        H5Pget_external(creation, 0, other.size() - 1, other.data(), nullptr, nullptr);
        refuse_outside(file, name, other.data());
    }
    std::size_t sources = 0;
    if (H5Pget_layout(creation) != H5D_VIRTUAL || H5Pget_virtual_count(creation, &sources) < 0) return;
    for (std::size_t i = 0; i < sources; ++i) {
        other = {};
        H5Pget_virtual_filename(creation, i, other.data(), other.size() - 1);
        if (std::string(other.data()) != ".") refuse_outside(file, name, other.data());
    }
}

void require_filters(hid_t creation, const std::string& name, const std::string& file) {
    for (int i = 0; i < H5Pget_nfilters(creation); ++i) {
        unsigned flags = 0, configuration = 0;
        std::size_t values = 0;
        std::array<char, 64> filter{};
        const H5Z_filter_t id = H5Pget_filter2(creation, static_cast<unsigned>(i), &flags, &values, nullptr,
                                               filter.size() - 1, filter.data(), &configuration);
        if (id >= 0 && H5Zfilter_avail(id) <= 0)
            throw ReadError(file, 0,
                            fmt::format("the dataset '{}' is compressed by the filter {} '{}', which is not here", name,
                                        id, shown(filter.data())),
                            "no compression, or gzip");
    }
}

}  // namespace

Hdf5Handle open_hdf5(const std::string& file) {
    constexpr std::size_t slots = 12421, bytes = std::size_t{32} << 20;  // a prime about 100 times the chunks it holds
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_cache(access, 0, slots, bytes, 1.0);
    return {H5Fopen(file.c_str(), H5F_ACC_RDONLY, access), H5Fclose};
}

std::vector<hsize_t> extents_of(hid_t dataset) {
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    const int rank = space.valid() ? H5Sget_simple_extent_ndims(space) : 0;
    std::vector<hsize_t> sizes(static_cast<std::size_t>(std::max(0, rank)));
    if (rank > 0) H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
    return sizes;
}

void require_readable(hid_t dataset, const std::string& name, const std::string& file) {
    const Hdf5Handle creation(H5Dget_create_plist(dataset), H5Pclose);
    if (!creation.valid()) return;
    require_own_numbers(creation, name, file);
    require_filters(creation, name, file);
}

std::size_t Hdf5Channels::add_dataset(Hdf5Handle dataset, const std::string& name) {
    require_readable(dataset, name, file_);
    const int rank = static_cast<int>(extents_of(dataset).size());
    datasets_.push_back({std::move(dataset), name, rank});
    return datasets_.size() - 1;
}

std::vector<double> Hdf5Channels::band(const Hdf5Channel& like, hsize_t begin, hsize_t count, hsize_t low,
                                       hsize_t width) const {
    const Dataset& dataset = datasets_[like.dataset];
    std::vector<hsize_t> start(static_cast<std::size_t>(dataset.rank), 0), size(start.size(), 1);
    start[static_cast<std::size_t>(like.sample_axis)] = begin;
    size[static_cast<std::size_t>(like.sample_axis)] = count;
    if (like.channel_axis >= 0) {
        start[static_cast<std::size_t>(like.channel_axis)] = low;
        size[static_cast<std::size_t>(like.channel_axis)] = width;
    }
    const Hdf5Handle space(H5Dget_space(dataset.handle), H5Sclose);
    const hsize_t all = count * width;
    const Hdf5Handle memory(H5Screate_simple(1, &all, nullptr), H5Sclose);
    std::vector<double> values(all);
    if (H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) < 0 ||
        H5Dread(dataset.handle, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()) < 0)
        throw ReadError(file_, 0, fmt::format("the dataset '{}' cannot be read", dataset.name), "an undamaged file");
    return values;
}

void Hdf5Channels::read_together(std::size_t first, std::size_t last, hsize_t begin, hsize_t count,
                                 std::vector<std::vector<double>>& columns) const {
    const Hdf5Channel& like = channels_[first];
    hsize_t low = like.channel, high = like.channel;
    for (std::size_t i = first; i < last; ++i) {
        low = std::min(low, channels_[i].channel);
        high = std::max(high, channels_[i].channel);
    }
    const hsize_t width = high - low + 1;
    const hsize_t at_once = std::max<hsize_t>(1, numbers_at_once / width);
    for (hsize_t done = 0; done < count; done += at_once) {
        const hsize_t now = std::min(at_once, count - done);
        const std::vector<double> values = band(like, begin + done, now, low, width);
        const bool channel_first = like.channel_axis < like.sample_axis;
        for (std::size_t i = first; i < last; ++i) {
            const hsize_t offset = channels_[i].channel - low;
            for (hsize_t k = 0; k < now; ++k)
                columns[i].push_back(values[channel_first ? offset * now + k : k * width + offset]);
        }
    }
}

void Hdf5Channels::read(hsize_t begin, hsize_t count, std::vector<std::vector<double>>& columns) const {
    // Neighbours of one dataset lie together: a band of it is read once for all of them.
    for (std::size_t first = 0; first < channels_.size();) {
        std::size_t last = first + 1;
        while (last < channels_.size() && channels_[last].dataset == channels_[first].dataset &&
               channels_[last].sample_axis == channels_[first].sample_axis &&
               channels_[last].channel == channels_[last - 1].channel + 1)
            ++last;
        read_together(first, last, begin, count, columns);
        first = last;
    }
}

}  // namespace railpem::recordings

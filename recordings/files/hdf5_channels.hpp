#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

#include "recordings/files/hdf5_handle.hpp"

namespace railpem::recordings {

/// The file opened for reading; not valid when it is no HDF5 file. Its cache holds the chunks of several channels, so
/// that blocks of a compressed file do not inflate them again and again.
Hdf5Handle open_hdf5(const std::string& file);

/// Sizes of the dataset; empty for a single number, and for none at all.
std::vector<hsize_t> extents_of(hid_t dataset);

/// Throws ReadError when the numbers of the dataset lie outside of its file (external storage, virtual datasets), which
/// a recording has no business to name, or behind a filter that is not here.
void require_readable(hid_t dataset, const std::string& name, const std::string& file);

/// Where a channel lies in a dataset.
struct Hdf5Channel {
    std::size_t dataset = 0;  ///< as add_dataset() numbered it
    int sample_axis = 0;
    int channel_axis = -1;  ///< -1: the dataset is one channel
    hsize_t channel = 0;    ///< along channel_axis
};

/// Channels of the datasets of a file, read by blocks. Axes that a channel does not name have one element.
class Hdf5Channels {
  public:
    explicit Hdf5Channels(std::string file) : file_(std::move(file)) {}
    std::size_t add_dataset(Hdf5Handle dataset, const std::string& name);
    void add(const Hdf5Channel& channel) { channels_.push_back(channel); }
    /// Appends samples `begin` to `begin + count` of every channel to its column. Throws ReadError.
    void read(hsize_t begin, hsize_t count, std::vector<std::vector<double>>& columns) const;

  private:
    struct Dataset {
        Hdf5Handle handle;
        std::string name;
        int rank = 0;
    };
    void read_together(std::size_t first, std::size_t last, hsize_t begin, hsize_t count,
                       std::vector<std::vector<double>>& columns) const;
    std::vector<double> band(const Hdf5Channel& like, hsize_t begin, hsize_t count, hsize_t low, hsize_t width) const;

    std::string file_;
    std::vector<Dataset> datasets_;
    std::vector<Hdf5Channel> channels_;
};

}  // namespace railpem::recordings

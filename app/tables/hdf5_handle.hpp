#pragma once

#include <hdf5.h>

#include <string>

#include "app/output_folder.hpp"

namespace railpem::app {

/// An HDF5 identifier, given back at the end. `failure`: what the user is told when there is none.
struct Hdf5Handle {
    hid_t id;
    herr_t (*close)(hid_t);
    Hdf5Handle(hid_t opened, herr_t (*closer)(hid_t), const std::string& failure) : id(opened), close(closer) {
        if (id < 0) throw OutputError(failure);
    }
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    ~Hdf5Handle() { close(id); }
};

/// The text attribute "provenance" of a file or data set.
inline void write_hdf5_stamp(hid_t owner, const std::string& text, const std::string& failure) {
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, failure), type(H5Tcopy(H5T_C_S1), H5Tclose, failure);
    H5Tset_size(type.id, text.size());
    H5Tset_strpad(type.id, H5T_STR_NULLPAD);
    const Hdf5Handle attribute(H5Acreate2(owner, "provenance", type.id, space.id, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                               failure);
    if (H5Awrite(attribute.id, type.id, text.data()) < 0) throw OutputError(failure);
}

}  // namespace railpem::app

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

}  // namespace railpem::app

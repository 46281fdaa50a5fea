#pragma once

#include <hdf5.h>

#include <optional>
#include <string>
#include <vector>

#include "recordings/files/file_statements.hpp"

namespace railpem::recordings {

/// What the attributes of a dataset, or of its own group, say about one of its channels (from 0): unit, scale and
/// offset by the conventions of CF (`units`, `scale_factor`, `add_offset`) and TDMS (`unit_string`, `wf_increment`).
ColumnStatement hdf5_statement(hid_t dataset, hid_t group, std::size_t channel);

/// Hz, as the attributes of an object say; nothing when they do not.
struct StatedRate {
    double hz = 0.0;
    std::string where;
};
std::optional<StatedRate> hdf5_rate(hid_t object);

/// The numbers that stand for missing samples (`_FillValue`, `missing_value`).
std::vector<double> hdf5_fill_values(hid_t dataset);

/// Attributes that may be a calibration and are not applied, since their meaning is not agreed on: "gain" = 2 …
std::vector<std::string> hdf5_unused_scales(hid_t dataset);

}  // namespace railpem::recordings

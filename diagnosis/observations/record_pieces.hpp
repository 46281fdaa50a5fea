#pragma once
// Pieces of a record whose speed changes too much to be one observation.

#include "recordings/estimates/track_path.hpp"
#include "recordings/recording.hpp"

namespace railpem::diagnosis {

/// A stretch of a path, from its own beginning on; times in s of the path.
recordings::TrackPath stretch(const recordings::TrackPath& path, double from_s, double to_s);

/// A time series from one time to another, s from its first sample; without a measured irregularity.
recordings::Recording cut(const recordings::Recording& recording, double from_s, double to_s);

}  // namespace railpem::diagnosis

#pragma once
// A recording of both sides of a vehicle as one of each rail: the model is half a vehicle on one rail, and what the
// other rail does it does not say.

#include <string>
#include <vector>

#include "recordings/recording.hpp"

namespace railpem::diagnosis {

struct SideRecording {
    std::string suffix;  ///< of the recording's name: "_left", "_right", or nothing
    recordings::Recording recording;
};

/// The recording as it is, unless a place carries channels of the left and of the right side: then one with the
/// channels of the left, and of no stated side, and one with those of the right.
std::vector<SideRecording> one_rail_each(const recordings::Recording& recording);

}  // namespace railpem::diagnosis

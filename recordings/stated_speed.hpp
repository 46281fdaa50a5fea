#pragma once
// The speed that a recording states, in its description or by a channel of its own.

#include "recordings/recording.hpp"

namespace railpem::recordings {

struct StatedSpeed {
    double m_per_s = 0.0;                                ///< 0: not stated
    double standard_error = 0.0;                         ///< m/s; 0: not stated
    bool from_channel = false;                           ///< the description is silent
    double lowest_m_per_s = 0.0, highest_m_per_s = 0.0;  ///< of the channel; the stated one without one
};

/// That of the description; without one the mean of the speed channel, known as well as its values scatter, but to no
/// better than half a per cent.
StatedSpeed stated_speed(const Recording& recording);

}  // namespace railpem::recordings

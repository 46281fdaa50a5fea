#pragma once
// Loss factors that are the same at every frequency, replaced by laws that a motion in time can have.

#include <string>
#include <vector>

#include "track/track_parameters.hpp"

namespace railpem::track {

/// A constant loss factor answers before it is pushed (Crandall 1970): no record in time has it. The track whose pads
/// follow the causal law with the same loss, whose ballast dissipates by a dashpot as much at the resonance of the
/// sleeper on it, and whose rail has its loss factor at `kRailLossHz`, growing in proportion to the frequency. These
/// are the laws that `simulate` marches. Parts without a constant loss factor stay as they are.
TrackParameters causal_losses(TrackParameters track);

/// The parts that causal_losses() changes, in words; none: empty.
std::vector<std::string> constant_losses(const TrackParameters& track);

inline constexpr double kRailLossHz = 100.0;  ///< in the middle of the band in which a vehicle feels the rail

}  // namespace railpem::track

#pragma once
// Which seats have failed.

#include <cstdint>
#include <vector>

#include "track/track_parameters.hpp"

namespace railpem::track {

/// Share of stiffness and damping that the fastener of a seat still has: 1, or remaining_stiffness_fraction where it
/// has failed. Seat 0 is the pad at or behind wheel 1, indices grow towards the front. Failed are the seats divisible
/// by `every`, and a share `fraction` of all seats drawn by hashing `seed` with the index: every seat of an endless
/// track has its answer, the same in whatever order or number they are asked for.
double pad_scale(const FailedFasteners& failed, std::int64_t seat);

/// The same for a track, whose table of failed fasteners may be absent.
double pad_scale(const TrackParameters& track, std::int64_t seat);

/// The long-run mean of pad_scale over the seats.
double mean_pad_scale(const TrackParameters& track);

}  // namespace railpem::track

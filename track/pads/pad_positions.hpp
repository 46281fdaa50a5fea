#pragma once
// Where the seats are.

#include <cstdint>
#include <vector>

#include "track/track_parameters.hpp"

namespace railpem::track {

/// Positions of the pads used, m from the centre of the car, increasing: seats at multiples of the spacing, phased so
/// that wheel 1 stands wheel_offset_m ahead of one. `wheels_m`: wheel 1 (the foremost) first. `count` > 0: that many
/// pads about the centre of the car (modal rail), the one nearer to the front where two are equal. `count` = 0: as many
/// as reach so far beyond the outermost wheels that the static influence of the wheels, exp(−βx) with β⁴ = k/(4EI) on
/// the smeared unloaded foundation k, has decayed below 1e-10 (exact rail).
std::vector<double> pad_positions(const TrackParameters& track, const std::vector<double>& wheels_m, int count);

/// Index of the seat at a pad's position: 0 for the pad at or behind wheel 1, growing towards the front.
std::int64_t seat_index(const TrackParameters& track, const std::vector<double>& wheels_m, double pad_m);

}  // namespace railpem::track

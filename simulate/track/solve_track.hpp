#pragma once
// A step of the track window: assembled, begun, solved under loads, finished, moved on.

#include <array>
#include <vector>

#include "simulate/track/track_window.hpp"

namespace railpem::simulate {

/// Assembles rail and seats for the step and factorises. To be called again after a shift when seats differ.
void assemble(TrackWindow& track, const RadauStep& step);
void factorise_track(TrackWindow& track);

/// Moves the window one bay forward; the fresh bay is at rest.
void shift(TrackWindow& track, const RadauStep& step);

void begin_step(TrackWindow& track, const RadauStep& step);

/// Solves the stages for given loads. Returns the largest movement of a pad's nonlinear residual, N: zero for linear
/// pads.
double solve_track(TrackWindow& track, const RadauStep& step, const std::vector<StageLoad>& loads);

/// Rail displacement by the shape functions at both stages of the last solve, at the places of the load.
std::array<double, 2> rail_displacement(const TrackWindow& track, const RadauStep& step, const StageLoad& load);

void finish_step(TrackWindow& track, const RadauStep& step);

}  // namespace railpem::simulate

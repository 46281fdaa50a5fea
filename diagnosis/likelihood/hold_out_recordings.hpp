#pragma once
// Several recordings of one track: whole ones are held out.

#include <vector>

#include "diagnosis/observations/observation.hpp"

namespace railpem::diagnosis {

/// Where several recordings show the same quantity of the track (decay rates of both rails and of several days,
/// receptances at one place), the last quarter of them, one at least, is held out whole, and no third-octave of the
/// others: what sits in a single band can be found, and has to come back on another day or on the other rail. All of
/// them share one discrepancy, because what the model class cannot say of a track it cannot say of it on any day.
void hold_out_recordings(std::vector<Observation>& observations);

/// Length of the unseen part by that of the fitted one: in seconds, or in values where there are only those.
double unseen_share(const std::vector<Observation>& observations);

}  // namespace railpem::diagnosis

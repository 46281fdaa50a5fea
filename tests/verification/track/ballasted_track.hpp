#pragma once
// A ballasted variant of the paper's track: two layers, a shearing rail, dampers on it.

#include "tests/unit/track/wei2016_track.hpp"

namespace railpem::track {

inline TrackParameters ballasted_track() {
    TrackParameters track = wei2016_track();
    track.rail.beam = Beam::timoshenko;
    track.rail.cross_section_m2 = 7.7e-3;
    track.rail.loss_factor = 0.02;
    track.support = {.model = SupportModel::two_layer, .mass_kg = 150.0, .stiffness_n_per_m = 60e6, .loss_factor = 0.5};
    track.rail_dampers = {{.mass_kg_per_m = 15.0, .frequency_hz = 300.0, .loss_factor = 0.3}};
    return track;
}

}  // namespace railpem::track

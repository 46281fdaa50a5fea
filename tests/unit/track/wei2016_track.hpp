#pragma once
// The slab track of Wei et al. 2016 (Tables 1 and 2, eq. 2) for the tests of this folder.

#include <vector>

#include "track/track_parameters.hpp"

namespace railpem::track {

inline TrackParameters wei2016_track() {
    TrackParameters track;
    track.rail.youngs_modulus_pa = 2.06e11;
    track.rail.second_moment_of_area_m4 = 3.22e-5;
    track.rail.mass_kg_per_m = 60.64;
    track.spacing_m = 0.6;
    track.pads.static_stiffness_n_per_m = 26.7e6;
    track.pads.dynamic_to_static_ratio = 1.4;
    track.pads.preload_strength = 1.0;
    track.pads.reference_frequency_hz = 4.0;
    track.pads.exponent = 0.15;
    track.pads.damping_n_s_per_m = 7.5e4;
    track.pads.force_polynomial_n = {-451.8, 5.021e6, 3.368e9, 1.228e11, 4.01e13};
    track.statics.clip_preload_n = 20e3;
    track.statics.rail_weight_kg_per_m = 60.0;
    return track;
}

/// The published figures come out only with the lateral second moment of area in the static analysis.
inline TrackParameters wei2016_track_as_published() {
    TrackParameters track = wei2016_track();
    track.statics.second_moment_of_area_m4 = 5.24e-6;
    return track;
}

inline const std::vector<double> wei2016_wheels_m{10.2, 7.8, -7.8, -10.2};
inline constexpr double wei2016_wheel_load_n = 80e3;
inline constexpr int wei2016_pads = 61;

}  // namespace railpem::track

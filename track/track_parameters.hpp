#pragma once
// The whole track as data.

#include <vector>

#include "parameters/field.hpp"
#include "track/pad_parameters.hpp"
#include "track/rail_parameters.hpp"
#include "track/support_parameters.hpp"

namespace railpem::track {

/// The static loads and, when somebody really wants statics and dynamics to differ, the key that says so.
struct StaticParameters {
    double clip_preload_n = 20e3;  ///< per seat
    double gravity_m_per_s2 = 9.81;
    double wheel_load_n = 0.0;          ///< static load of one wheel; 0: from the masses of the vehicle
    double rail_weight_kg_per_m = 0.0;  ///< 0: the rail's own mass
    /// Second moment of area used in the static analysis only; 0: the rail's own. Wei et al. 2016, Figures 4 and 5,
    /// need the lateral value 5.24e-6 m⁴ although the dynamic model uses 3.22e-5 m⁴.
    double second_moment_of_area_m4 = 0.0;
};

struct TrackParameters {
    RailParameters rail;
    double spacing_m = 0.6;  ///< between the supports
    /// Distance from the pad at or behind wheel 1 to wheel 1; 0: wheel 1 stands over a pad.
    double wheel_offset_m = 0.0;
    PadParameters pads;
    SupportParameters support;
    StaticParameters statics;
    std::vector<RailDamper> rail_dampers;
    std::vector<FailedFasteners> failed_fasteners;  ///< at most one
};

parameters::Fields<TrackParameters> track_fields();
parameters::Fields<StaticParameters> static_fields();

/// Rules between parameters. Throws parameters::ParameterError (keys "track.…").
void check(const TrackParameters& track);

}  // namespace railpem::track

#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "simulate/march/profile.hpp"
#include "simulate/only_here_parameters.hpp"
#include "simulate/track/track_window.hpp"
#include "simulate/world_parameters.hpp"

namespace railpem::simulate {

/// moving: the vehicle runs along the track. standing: the wheels stay where they are and the irregularity is pulled
/// through between wheel and rail, as in Wei et al. 2016.
enum class Mode { moving, standing };

/// A speed against time: increasing times, speeds of at least 0 (a stop); linear between them, constant beyond. Time 0
/// is the first sample.
struct SpeedTable {
    std::vector<double> time_s, speed_m_per_s;
};

/// What an observer sees at the end of a step; for tests and for looking inside.
struct Glimpse {
    double time_s;
    std::array<double, 4> contact_force_n;
    std::array<double, 4> approach_m;
    std::array<double, 4> rail_displacement_m;  ///< at the contacts, upwards, local compliance included
    std::array<double, 4> irregularity_m;
    double energy_j;          ///< linear models only: kinetic and elastic energy of vehicle, rail, pads and contacts
    double dissipation_w;     ///< by all dampers
    double trackbed_force_n;  ///< sum of the forces of all seats on the rail, beyond the unloaded (moving) or static
                              ///< (standing) state
};

/// How a record is made. Every default stands beside its reason.
struct Options {
    Mode mode = Mode::moving;
    double seconds = 60.0;
    double sampling_rate_hz = 1000.0;
    double speed_m_per_s = 0.0;  ///< 0: the first speed of the case
    std::uint64_t seed = 1;
    /// Seed of the profile alone; not given: drawn from `seed`, so different records never share a profile.
    std::optional<std::uint64_t> profile_seed;
    double profile_length_m = 0.0;  ///< period of the drawn profile; 0: as long as the record needs. To share a line
                                    ///< between records give both
    bool repeat_profile =
        false;  ///< let the profile of that length repeat: a periodic steady state, for comparisons line by line
    std::optional<MeasuredProfile> measured_profile;
    double speed_fluctuation =
        0.0;  ///< relative standard deviation of a slow wander of the speed (periods of 15 to 80 s)

    std::optional<SpeedTable> speed_table;  ///< instead of a constant speed
    bool speed_channel = false;             ///< record the speed beside the accelerations
    WorldParameters world;                  ///< the ideal one unless said otherwise

    /// white noise of every channel from 0.5 Hz to half the sampling rate, beside that of the case's sensors
    double noise_rms_m_per_s2 = 0.0;

    /// moving, and the case leaves the contact linear: Hertz, unless this is set.
    bool linear_contact = false;
    /// standing only: pads work on their tangent at the static equilibrium.
    bool linear_pads = false;
    OnlyHereParameters only_here;

    /// Marching step at most, s: at 180 Hz the method's damping is then 1.6e-4 of critical and half the step changes no
    /// sixth-octave level by more than 0.01 dB. Shorter by itself where pads hardly damp.
    double largest_step_s = 0.2e-3;
    /// Time before the record, s: five times the slowest decay of an ordinary vehicle (body bounce at 1 Hz, 15 %).
    double settling_s = 5.0;
    WindowOptions window;

    std::function<void(double done_s, double total_s)> progress;  ///< called about a hundred times
    std::function<void(const Glimpse&)> observer;                 ///< called at every step of the record; costs time
};

/// Seed of all that belongs to the line and not to the record: profile, dips, seats.
std::uint64_t line_seed(const Options& options);

}  // namespace railpem::simulate

#pragma once

#include <cstdint>
#include <vector>

#include "simulate/march/options.hpp"
#include "simulate/world_draws.hpp"

namespace railpem::simulate {

/// A speed that varies, on a uniform grid in time: a monotone cubic between neighbours (Fritsch & Carlson 1980, with
/// the harmonic mean of the neighbouring slopes), so that no speed becomes negative between two that are not. Constant
/// beyond its ends.
struct SpeedCurve {
    double first_s = 0.0, step_s = 1.0;
    std::vector<double> speed_m_per_s;
    std::vector<double> acceleration_m_per_s2;
    std::vector<double> distance_m;  ///< the integral of the cubics, without error but rounding; 0 at time 0

    double speed(double time_s) const;
    double distance(double time_s) const;
};

/// Distance travelled against time: constant speed with, when asked for, a slow wander, or a curve instead of both.
struct Travel {
    struct Wave {
        double amplitude, frequency_hz, phase;
    };
    double speed_m_per_s = 0.0;
    std::vector<Wave> wander;  ///< of the relative speed
    SpeedCurve curve{};        ///< empty: none

    double distance(double time_s) const;  ///< 0 at time 0
    double speed(double time_s) const;
};

/// `speed_m_per_s` with the wander, the ramp and the random changes that the options ask for, or the options' table
/// instead of the constant speed. The curve reaches from `start_s` to `end_s`; random changes depend on seed and time
/// alone.
Travel make_travel(double speed_m_per_s, const Options& options, double start_s, double end_s);

/// The highest speed that occurs, the wander of a constant speed left out.
double highest_speed_m_per_s(const Travel& travel);

/// Mean, extremes and rms of the speed from 0 to `seconds`, into the fields of `draws`.
void describe_travel(const Travel& travel, double seconds, WorldDraws& draws);

}  // namespace railpem::simulate

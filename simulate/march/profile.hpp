#pragma once

#include <cstdint>
#include <vector>

#include "spectra/irregularity_parameters.hpp"

namespace railpem::simulate {

/// Height of the running surface along the line, upwards positive, on a uniform grid; cubic interpolation between.
struct Profile {
    double first_m = 0.0;
    double step_m = 1.0;
    std::vector<double> height_m;
    bool periodic = false;  ///< goes on from its end at its start; otherwise constant beyond the ends

    double at(double position_m) const;
};

/// Profile given by measurement: increasing positions with heights.
struct MeasuredProfile {
    std::vector<double> position_m, height_m;
};

/// Share of the spectrum that every wheel meets for itself: min(1, at_1_m·(n·1 m)^exponent) at n cycles/m. The rest is
/// common to all, so that each wheel meets the whole spectrum and two of them are coherent by (1 − share)².
struct OwnShare {
    double at_1_m = 0.0, exponent = 1.0;
    double at(double cycles_per_m) const;
};

struct ProfileRequest {
    double from_m = 0.0, to_m = 0.0;  ///< stretch that the wheels will meet
    double length_m = 0.0;            ///< period of the drawn profile; 0: the next that holds the stretch
    bool may_repeat = false;
    double shortest_wavelength_m = 0.0;  ///< shorter waves are left out (the integrator could not follow them)
    double patch_half_length_m = 0.0;    ///< moving average over twice this length; 0: none
    std::uint64_t seed = 1;
    OwnShare own;  ///< left out of what draw_profile() gives
};

/// Gaussian profile with the case's spectrum: every spatial frequency k/length up to 1/shortest gets an independent
/// complex normal amplitude of variance S(n)/length, drawn by seed and k alone. Two requests with equal seed and length
/// are therefore the same line at any speed. Joints are added at their spacing from a drawn phase; then the contact
/// patch averages. Non-repeating within the length, which is at least the stretch asked for. Throws
/// parameters::ParameterError when `length_m` is shorter than the stretch.
Profile draw_profile(const spectra::IrregularityParameters& irregularity, const ProfileRequest& request);

/// The same from measured heights, interpolated, with the patch average. Throws parameters::ParameterError when they do
/// not cover the stretch.
Profile resample_profile(const MeasuredProfile& measured, const ProfileRequest& request);

/// Adds to a drawn profile what the wheel (0 to 3) meets for itself; for a measured one too, by the case's spectrum.
/// Drawn by seed, wheel and spatial frequency alone.
void add_own_profile(Profile& profile, const spectra::IrregularityParameters& irregularity,
                     const ProfileRequest& request, std::size_t wheel);

/// Standard deviation of the heights between two positions, m.
double profile_rms(const Profile& profile, double from_m, double to_m);

}  // namespace railpem::simulate

#pragma once
// How far the marched world is from the one of the equations: speed, seats, line, what each wheel meets, sensors.

namespace railpem::simulate {

/// Every imperfection of a simulated recording; the defaults are the ideal world. A strength of zero is absence, and a
/// record without any imperfection has the bits that it had before there were any. Values of the grades, ranges and the
/// sources of each number: world_keys() in `world_grades.hpp`.
struct WorldParameters {
    // Speed: v(t) = v·(1 + rms·g(t)), g a smooth Gaussian process. Its acceleration has the rms v·rms·√(π/2)/time.
    double speed_rms = 0.0;            ///< relative
    double speed_correlation_s = 8.0;  ///< integral of the correlation from 0 on
    double speed_end_m_per_s = 0.0;    ///< reached linearly at the end of the record; 0: no ramp

    // Seats: factors with mean 1 whose logarithms are normal.
    double pad_scatter = 0.0;          ///< standard deviation of the logarithm of a pad's stiffness
    double pad_damping_scatter = 0.0;  ///< the same of its dashpot, beside its stiffness
    double support_scatter = 0.0;      ///< the same of what lies under it, which varies smoothly along the line
    double support_length_m = 20.0;    ///< correlation length of that, as for the speed
    /// Single-layer tracks: share of the static compliance of a seat that is the ground's. 1/k = (1 − s)/k_pad +
    /// s/k_ground with both parts at the case's stiffness on average.
    double ground_share = 0.2;

    // Line: what a wheel meets.
    /// Share of the irregularity's spectrum that every wheel meets for itself: min(1, share·(1 m/wavelength)^exponent).
    /// Two wheels are then coherent by (1 − share)².
    double own_irregularity_at_1_m = 0.0;
    double own_irregularity_exponent = 1.0;
    double rough_level_db = 0.0;   ///< of the rough stretch over the rest
    double rough_share = 0.2;      ///< of the record that it takes
    double impacts_per_km = 0.0;   ///< dips at random places: raised cosines
    double impact_depth_m = 2e-4;  ///< mean; drawn between half and one and a half of it
    double impact_length_m = 0.5;  ///< mean; drawn between 0.7 and 1.3 of it

    // Sensors.
    double gain_scatter = 0.0;        ///< standard deviation of a channel's calibration, relative
    double gain_drift = 0.0;          ///< standard deviation of its change over the record, relative
    double noise_rms_m_per_s2 = 0.0;  ///< of every channel from 0.5 Hz to half the sampling rate
    double noise_corner_hz = 10.0;    ///< S(f) ∝ 1 + corner/f: below it the noise grows with 1/f
    double tone_rms_m_per_s2 = 0.0;   ///< a sharp tone on one channel, drawn
    double tone_hz = 50.0;

    bool operator==(const WorldParameters&) const = default;
};

}  // namespace railpem::simulate

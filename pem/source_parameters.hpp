#pragma once
// Sources of excitation beside the irregularity, and what the sensors do to what they measure.

#include <string>
#include <vector>

#include "parameters/field.hpp"

namespace railpem::pem {

/// A wheel that is not round: radius deviation amplitude·cos(order·θ + phase), phase unknown. Line at order·v/(2πR),
/// an independent source of rank one at that wheel.
struct WheelOutOfRoundness {
    int wheel = 1;
    int order = 1;
    double amplitude_m = 20e-6;
};

/// Supports felt by the wheels: the quasi-static deflection under a wheel differs over and between the pads.
/// 0: not modelled; 1: as computed from the case's own compliance; more or less: an excess over it.
struct SleeperPassing {
    double amplitude_factor = 0.0;
};

/// What the acquisition chain does to one channel: gain (negative: inverted), mounting resonance (second-order low pass
/// 1/(1 − (f/f_m)² + 2iζf/f_m)), delay (later: positive), and additive noise with PSD S(f) = rms²-normalised
/// (f/10 Hz)^(slope/(10·log10 2)) between 0.5 Hz and half the sampling rate (slope in dB per octave, negative:
/// 1/f-like).
struct SensorParameters {
    std::string channel;
    double gain = 1.0;
    double resonance_frequency_hz = 0.0;  ///< 0: rigid mount
    double resonance_damping_ratio = 0.05;
    double noise_rms_m_per_s2 = 0.0;
    double noise_slope_db_per_octave = 0.0;
    double delay_s = 0.0;
};

parameters::Fields<WheelOutOfRoundness> wheel_out_of_roundness_fields();
parameters::Fields<SleeperPassing> sleeper_passing_fields();
parameters::Fields<SensorParameters> sensor_fields();

}  // namespace railpem::pem

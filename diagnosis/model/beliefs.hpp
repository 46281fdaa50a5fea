#pragma once
// What is believed of every unknown before anything is recorded, in one place: widths, bounds and steps.

#include <array>

#include "diagnosis/observations/observation_options.hpp"

namespace railpem::diagnosis {

/// Means, standard deviations and bounds of the unknowns of retuning and nuisance, in their coordinates (logarithms of
/// factors where nothing else is said), and the steps of their numerical derivatives.
struct Beliefs {
    // Numbers of the case, whose deviations are their tolerances.

    double least_number = 0.05, most_number = 20.0;  ///< factors: bounds of a number. Chosen; not calibrated
    /// Step. The slopes of all numbers nearly cancel along their common scale: over 1e-6 a difference is off by 1e-8 of
    /// the information (bogie mass, primary damping), which moved the scale by a deviation; over 1e-8 rounding does a
    /// third of that. Judged on that case
    double number_step = 1e-7;
    /// step of what has none of its own, and of an effect's parameter over its range: what a step adds at second order
    /// is seen against the noise. Chosen; not calibrated
    double usual_step = 1e-6;
    /// step of what enters smoothly: irregularity, passing of sleepers, width of lines. Chosen; not calibrated
    double smooth_step = 1e-5;

    // Irregularity, in log power.

    double nodes_per_octave = 2.0;  ///< over wavelength: what a structure cannot imitate. Chosen; not calibrated
    /// of a node: 1.5 dB, the scatter between sections of a line. Judged on that scatter
    double irregularity_deviation = 0.35;
    /// of all wavelengths together: 1 dB. Judged: at 1.5 dB a track 8 dB smoother than believed was consistent
    double level_deviation = 0.23;
    double measured_level_deviation = 1e-3;  ///< where nodes are measured: they carry the level. Derived
    double most_irregularity = 4.0;          ///< bound of nodes and level, both ways. Chosen; not calibrated

    // What each wheel meets by itself, in the logarithm of its share of the irregularity's power: the contact line
    // wanders, seats scatter.

    double met_alone_nodes_per_octave = 1.0;  ///< over wavelength: broad. Chosen; not calibrated
    /// a share of 1e-4, known to a factor of ten: coherences of wheels of a bogie are 0.9 at best on worn track, better
    /// than what a minute can tell on new one. Chosen between both; not calibrated
    double log_met_alone = -9.2, met_alone_deviation = 2.3;
    /// bounds: nothing that shows, and a quarter of the power. Chosen
    double log_least_met_alone = -21.0, log_most_met_alone = -1.4;

    // A sensor's calibration, in log power; its deviation is stated.

    double most_calibration = 2.0;  ///< bound, both ways. Chosen; not calibrated

    // Lines.

    double passing_deviation = 0.10;  ///< of the amplitude of sleeper passing. Chosen; not calibrated
    double most_passing = 3.0;        ///< bound, both ways. Chosen; not calibrated
    /// of the speed's fluctuation: nobody states how steady a speed was. Chosen; not calibrated
    double fluctuation_deviation = 1.5;
    /// relative: bounds. Stated: what a case may state of running.speed_fluctuation
    double least_fluctuation = 1e-5, most_fluctuation = 0.05;

    // A recording.

    double most_speed = 0.1;         ///< bound of a speed, both ways; its deviation is stated. Chosen; not calibrated
    double speed_step = 1e-8;        ///< chosen; not calibrated
    double noise_below_guess = 2.0;  ///< mean of a noise below its first guess, which is an upper one. Chosen
    double noise_deviation = 3.0;    ///< in log power: known to a factor of 20. Chosen; not calibrated
    /// bound of what grows with 1/f, at 1 Hz, above the guess of the white part: a corner at half the band. Chosen
    double flicker_high = 5.0;
    double noise_low = 30.0, noise_high = 3.0;  ///< bounds below and above the guess. Chosen; not calibrated
    double scale_deviation = 10.0;  ///< in log power, of a channel without a scale: as good as anything. Chosen
    double most_scale = 40.0;       ///< bound about the guess, both ways. Chosen; not calibrated

    // The floor: relative amplitude of what the model class cannot say.

    std::array<double, 6> floor_nodes_hz{ObservationOptions{}.low_hz,      5.0, 12.0, 30.0, 75.0,
                                         kExpectationSettings.band_high_hz};  ///< 1.2 to 1.3 octaves apart. Chosen
    double sound_floor = 5e-4;     ///< what two sound simulators differ by. Judged on that difference
    double log_floor_mean = -7.6;  ///< derived: the logarithm of that, rounded
    double floor_deviation = 2.5;  ///< a factor of twelve: bands that no state explains must lose their weight. Judged
    double log_least_floor = -14.0, log_most_floor = 1.0;  ///< bounds. Chosen; not calibrated

    // The discrepancy of a scalar recording, relative, of a level.

    double scalar_discrepancy =
        0.05;  ///< what a model of this class is good for without phases. Chosen; not calibrated
    double scalar_discrepancy_deviation = 0.5;                 ///< of its logarithm. Chosen; not calibrated
    double least_discrepancy = 1e-4, most_discrepancy = 10.0;  ///< bounds. Chosen; not calibrated
};

inline constexpr Beliefs kBeliefs{};

}  // namespace railpem::diagnosis

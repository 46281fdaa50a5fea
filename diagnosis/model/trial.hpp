#pragma once
// One supposition about vehicle, track, excitation and sensors, and the unknowns that move it.

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/model/beliefs.hpp"
#include "diagnosis/observations/believed_case.hpp"
#include "diagnosis/observations/observation.hpp"

namespace railpem::diagnosis {

/// Groups of channels that share a discrepancy floor.
inline constexpr int kFloorGroups = 4;  ///< body, bogies, wheels, rail
inline constexpr int kFloorNodeCount = static_cast<int>(kBeliefs.floor_nodes_hz.size());

/// A supposition. The numbers are those of the case before its effects.
struct Trial {
    pem::CaseParameters numbers;
    std::vector<EffectInstance> effects;
    std::vector<double> speed_m_per_s;           ///< per observation
    std::vector<std::vector<double>> noise_psd;  ///< per observation and channel: its white part
    /// and at 1 Hz what falls with 1/f; none: nothing
    std::vector<std::vector<double>> flicker_psd;
    /// per observation: relative deviation of a scalar value that the model class cannot say
    std::vector<double> discrepancy;
    /// per observation and channel: of its power; of a sensor's calibration, or of one whose unit cannot be trusted
    std::vector<std::vector<double>> log_gain;
    /// Relative amplitude of what the model class cannot say, incoherent between channels: [group][node].
    std::vector<double> floor = std::vector<double>(static_cast<std::size_t>(kFloorGroups) * kFloorNodeCount, 0.0);
};

/// The group whose floor a response shares.
std::size_t floor_group(std::size_t response);

/// Weights of the floor's nodes at a frequency: linear in log f.
struct FloorPlace {
    int node = 0;        ///< lower node
    double share = 0.0;  ///< of the next one
};
FloorPlace floor_place(double frequency_hz);

/// What an unknown moves.
enum class UnknownKind {
    number,
    effect,
    irregularity,
    passing,
    width,
    correction,
    gain,
    calibration,
    met_alone,
    speed,
    noise,
    flicker,
    floor,
    discrepancy
};

/// An unknown in a coordinate of its own (logarithm of a factor, say) with a Gaussian belief and bounds.
struct Unknown {
    UnknownKind kind = UnknownKind::number;
    std::string name;
    double mean = 0.0;
    double deviation = 1.0;
    double low = -1e300;
    double high = 1e300;
    double step = kBeliefs.usual_step;  ///< of the numerical derivative
    int observation = -1;               ///< the only one that it moves; −1: all
    int index = 0;  ///< noise, calibration: channel; floor: group·nodes + node; effect: place in Trial::effects
    Element element = Element::body;                        ///< correction: where
    parameters::Nature nature = parameters::Nature::other;  ///< number: of what kind
    std::function<void(Trial&, double)> set;
};

/// The case of a trial as it stands in an observation: with load, effects and moving wheels.
pem::CaseParameters case_of(const Trial& trial, const BelievedCase& believed, const Observation& observation);

/// The believed case as a trial.
Trial believed_trial(const BelievedCase& believed, const std::vector<Observation>& observations);

/// Unknowns of retuning and nuisance: numbers within their tolerances, irregularity over wavelength, what wheels meet
/// alone, calibrations, speeds, noise, floor.
std::vector<Unknown> nuisance_unknowns(const BelievedCase& believed, const std::vector<Observation>& observations);

/// Unknowns of the instance `effect_index` of a trial's effects: its continuous parameters.
std::vector<Unknown> effect_unknowns(const EffectInstance& instance, std::size_t effect_index);

/// The parameter of an effect that an unknown is; null for every other unknown.
const EffectParameter* parameter_of(const Unknown& unknown);

/// Noise of a channel at a frequency > 0: its white part and what grows with 1/f.
double noise_at(const Trial& trial, std::size_t observation, std::size_t channel, double frequency_hz);

/// Applies values to a trial.
void set_values(Trial& trial, const std::vector<Unknown>& unknowns, const std::vector<double>& values);

/// Value of an effect's parameter in its coordinate, and back.
double to_coordinate(const EffectParameter& parameter, double value);
double from_coordinate(const EffectParameter& parameter, double coordinate);

}  // namespace railpem::diagnosis

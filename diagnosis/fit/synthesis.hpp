#pragma once
// Recordings drawn from what the likelihood supposes, without marching anything in time: for thresholds, coverage and
// tests.

#include <cstdint>
#include <string>
#include <vector>

#include "diagnosis/likelihood/likelihood.hpp"

namespace railpem::diagnosis {

/// An observation as a record of `seconds`, sampled at 1 kHz, would give it, without anything measured yet: kernel,
/// band, averages and their parts. `responses` are names of pem::response_names() ("body", "bogie_1", "wheel_4"), taken
/// as accelerations. The noise guess is that of a sensor with 0.02 m/s² rms. Throws parameters::ParameterError when a
/// part is shorter than a window or no usable band is left.
Observation observation_shape(double speed_m_per_s, double payload_kg, double seconds,
                              const std::vector<std::string>& responses, const pem::CaseParameters& believed,
                              const ObservationOptions& options);

/// The observation `shape`, the `index`-th of the truth's, with cross-spectra drawn as if `truth` were true: in every
/// bin complex Wishart about complete_prediction() without floor, with round(averages) degrees of freedom, bins
/// independent (averages is the number that makes them count so), the power of the excitation in every bin drawn first
/// (whitened_bin.hpp). The parts fitted and held_out are independent; all is their mean, weighted with their averages.
/// The same seed gives the same draw. (Goodman 1963, Ann. Math. Statist. 34.)
Observation synthesise(const Observation& shape, std::size_t index, const Trial& truth, const BelievedCase& believed,
                       std::uint64_t seed);

}  // namespace railpem::diagnosis

#pragma once

#include "pem/case_parameters.hpp"
#include "simulate/march/options.hpp"
#include "simulate/recording.hpp"

namespace railpem::simulate {

/// Marches the vehicle over the track for the asked time and gives what the accelerometers would have recorded.
/// The same case, options and seed give identical bits.
///
/// Throws parameters::ParameterError: a record too short for a single average at the case's lowest frequency, a
/// sampling rate below twice its highest, channels of sensors that do not exist, a measured profile that does not cover
/// the line.
Recording simulate(const pem::CaseParameters& parameters, const Options& options);

}  // namespace railpem::simulate

#pragma once
// What the acquisition chain does to the responses that it measures.

#include <complex>
#include <string>

#include "pem/case_parameters.hpp"
#include "pem/coupling/solution.hpp"
#include "pem/source_parameters.hpp"

namespace railpem::pem {

/// Complex factor of gain, mounting resonance and delay: g·e^{−iωτ}/(1 − (f/f_m)² + 2iζf/f_m); times the free
/// correction of its channel, if there is one.
std::complex<double> sensor_transfer(const SensorParameters& sensor, double frequency_hz,
                                     const lanes::FactorCurve* correction = nullptr);

/// What lies between a response and the channel that measures it: the transfers of all its sensors, with what a
/// diagnosis corrects of its channels (Modifiers::sensors). 1 without any.
std::complex<double> channel_transfer(const CaseParameters& parameters, const std::string& response,
                                      double frequency_hz);

/// PSD of the additive noise, (m/s²)²/Hz: C·(f/10 Hz)^(slope/(10·log10 2)) with C such that the integral from 0.5 Hz to
/// 500 Hz is rms².
double sensor_noise_psd(const SensorParameters& sensor, double frequency_hz);

/// Applies every sensor of the case to the responses it measures: its transfer multiplies the pseudo-responses of all
/// sources, its noise is a source of its own that only that response feels.
void apply_sensors(const CaseParameters& parameters, Solution& solution);

}  // namespace railpem::pem

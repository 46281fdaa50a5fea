#pragma once
// What excites a case, as data: broadband sources, spectral lines, and either on a frequency grid.

#include <array>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "lanes/complex_lanes.hpp"
#include "pem/wheel_matrix.hpp"

namespace railpem::pem {

/// Frequency lines of one group and the width of the bin that each stands for.
struct LineGroup {
    lanes::Real omega{};   ///< rad/s
    double step_hz = 0.0;  ///< bins are [f − step/2, f + step/2]
};

/// An independent source of excitation: the pseudo-irregularity e(ω)·√S(ω) under each wheel, m/√Hz. Different sources
/// are uncorrelated, so the cross-spectral matrix of the responses is the sum over them.
struct Source {
    std::string name;
    std::function<WheelVector(const LineGroup&)> amplitude;
};

/// A spectral line: vibration of the wheels' irregularity at one frequency, with fixed phases between the wheels.
struct SpectralLine {
    double frequency_hz = 0.0;
    std::array<std::complex<double>, 4> amplitude_m{};  ///< peak amplitude under each wheel
};

/// A broadband source that the wheels meet one after the other.
struct DelayedSpectrum {
    std::string name;
    std::function<double(double frequency_hz)> psd_m2_per_hz;
    std::array<double, 4> share{1.0, 1.0, 1.0, 1.0};  ///< of its amplitude under each wheel
    /// Where wheels do not meet the same: the amplitude under each, m/√Hz, delays included; the two above are then
    /// those of wheel 1.
    std::function<std::array<std::complex<double>, 4>(double frequency_hz)> under_wheels = nullptr;
};

/// What the wheels meet of it at a frequency, delays included, m/√Hz.
std::array<std::complex<double>, 4> met(const DelayedSpectrum& source, const std::vector<double>& wheels_m,
                                        double speed_m_per_s, double frequency_hz);

/// A source made of lines, coherent among the wheels.
struct LineSet {
    std::string name;
    std::vector<SpectralLine> lines;
};

/// Everything that excites a case at speed v, independent of each other:
/// - "irregularity": broadband spectrum with corrugation, smoothed by the contact patch; - "failed_fasteners": random
/// ones;
/// - "joints": lines at n·v/spacing; - "wheel_n": out-of-roundness, lines at order·v/(2πR), that wheel only;
/// - "sleeper_passing": see passing_lines.hpp.
struct Excitation {
    std::vector<DelayedSpectrum> broadband;
    std::vector<LineSet> lines;
};

/// What of the excitation the standing load and the track's deflection make: costly, and common to cases that differ in
/// vehicle or irregularity only.
struct TrackExcitation {
    std::vector<SpectralLine> deflection;  ///< passing_lines()
    std::vector<SpectralLine> passing;     ///< those with what their own forces do
    /// unit_excess_lines(), with the same; of no use without an excess, and empty
    std::vector<SpectralLine> excess;
    std::function<std::array<std::complex<double>, 4>(double)> failed;  ///< failed_fastener_amplitudes()
    double wheel_load_n = 0.0;                                          ///< under which they were computed
    double amplitude_factor = 0.0;                                      ///< own_passing() of then
};

/// Phase e^{−iω·d_j/v} with which wheel j meets what wheel 1 meets, d_j = x_1 − x_j.
std::complex<double> delay_phase(const std::vector<double>& wheels_m, std::size_t wheel, double frequency_hz,
                                 double speed_m_per_s);

/// A broadband source as the wheels meet it, on a frequency grid.
Source delayed_source(DelayedSpectrum spectrum, std::vector<double> wheels_m, double speed_m_per_s);

/// A line set as a source on a frequency grid. Each line is a Gaussian of standard deviation f·speed_fluctuation whose
/// PSD in a bin is its exact mean over the bin, so that Σ PSD·step over the table is amplitude²/2 whatever the grid
/// (spectra/line_power.hpp). The phases between the wheels are those of the line: a speed that fluctuates moves the
/// frequency, not the wavelength. Where lines overlap their powers add and the strongest gives the phases.
Source line_source(std::string name, std::vector<SpectralLine> lines, double speed_fluctuation);

}  // namespace railpem::pem

#pragma once
// Smooth factors of a power spectrum as data: the natural logarithm of the factor, linear in the logarithm of the
// wavelength or frequency between nodes and constant beyond them.

#include <vector>

namespace railpem::spectra {

/// A power factor by wavelength; no nodes: 1.
struct LogSpline {
    std::vector<double> wavelength_m;  ///< > 0, increasing
    std::vector<double> log_factor;    ///< natural logarithm, one per node

    bool empty() const { return wavelength_m.empty(); }
    /// The factor itself at a wavelength > 0 in m.
    double at(double wavelength) const;

    bool operator==(const LogSpline&) const = default;
};

/// A power factor by frequency; no nodes: 1.
struct LogFrequencySpline {
    std::vector<double> frequency_hz;  ///< > 0, increasing
    std::vector<double> log_factor;    ///< natural logarithm, one per node

    bool empty() const { return frequency_hz.empty(); }
    /// The factor itself at a frequency > 0 in Hz.
    double at(double frequency) const;

    bool operator==(const LogFrequencySpline&) const = default;
};

}  // namespace railpem::spectra

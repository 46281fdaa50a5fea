#include "spectra/log_spline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace railpem::spectra {

namespace {

double interpolated(const std::vector<double>& nodes, const std::vector<double>& values, double x) {
    assert(values.size() == nodes.size());
    if (nodes.empty()) return 0.0;
    if (x <= nodes.front()) return values.front();
    if (x >= nodes.back()) return values.back();
    const std::size_t i = static_cast<std::size_t>(std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin());
    const double share = std::log(x / nodes[i - 1]) / std::log(nodes[i] / nodes[i - 1]);
    return values[i - 1] + share * (values[i] - values[i - 1]);
}

}  // namespace

double LogSpline::at(double wavelength) const {
    return std::exp(interpolated(wavelength_m, log_factor, wavelength));
}

double LogFrequencySpline::at(double frequency) const {
    return std::exp(interpolated(frequency_hz, log_factor, frequency));
}

}  // namespace railpem::spectra

#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "lanes/complex_lanes.hpp"

namespace railpem::lanes {

/// A complex factor that varies smoothly with frequency: linear in log f between nodes, constant beyond them; no nodes: 1.
/// The time factor is e^{iωt}: a positive imaginary part on a stiffness dissipates, on a mass it feeds.
struct FactorCurve {
    std::vector<double> frequency_hz;         ///< > 0, increasing
    std::vector<std::complex<double>> value;  ///< one per node

    bool empty() const { return frequency_hz.empty(); }

    /// ω in rad/s; for negative ω the conjugate of the value at |ω|, as a real motion asks for.
    std::complex<double> at(double omega) const {
        const std::complex<double> factor = at_frequency(std::abs(omega) / (2.0 * std::numbers::pi));
        return omega < 0.0 ? std::conj(factor) : factor;
    }

    /// The same, one ω per lane.
    Complex at(Real omega) const {
        Complex factor;
        for (int lane = 0; lane < width; ++lane) factor.set(lane, at(omega[lane]));
        return factor;
    }

  private:
    std::complex<double> at_frequency(double f) const {
        assert(value.size() == frequency_hz.size());
        if (empty()) return 1.0;
        if (f <= frequency_hz.front()) return value.front();
        if (f >= frequency_hz.back()) return value.back();
        const auto above = std::upper_bound(frequency_hz.begin(), frequency_hz.end(), f);
        const std::size_t i = static_cast<std::size_t>(above - frequency_hz.begin());
        const double share = std::log(f / frequency_hz[i - 1]) / std::log(frequency_hz[i] / frequency_hz[i - 1]);
        return value[i - 1] + share * (value[i] - value[i - 1]);
    }
};

}  // namespace railpem::lanes

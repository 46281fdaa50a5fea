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

/// A complex factor that varies smoothly with frequency: between nodes cubic in log f with the slopes of
/// parabolas through three nodes (of two nodes linear), constant beyond them; no nodes: 1.
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
        const Places places(frequency_hz, i);
        const double step = places(i) - places(i - 1), t = (std::log(f) - places(i - 1)) / step;
        const std::complex<double> rise = value[i] - value[i - 1], from = step * slope(places, i - 1) - rise,
                                   to = rise - step * slope(places, i);
        return value[i - 1] + t * rise + t * (1.0 - t) * ((1.0 - t) * from + t * to);
    }

    /// Logarithms of the nodes about the interval that ends at one: each is asked for up to six times.
    class Places {
      public:
        Places(const std::vector<double>& nodes, std::size_t end)
            : first_(end < 2 ? 0 : std::min(end - 2, nodes.size() < 3 ? 0 : nodes.size() - 3)) {
            for (std::size_t k = first_; k < std::min(first_ + 4, nodes.size()); ++k)
                log_[k - first_] = std::log(nodes[k]);
        }
        double operator()(std::size_t node) const { return log_[node - first_]; }

      private:
        std::size_t first_;
        double log_[4];
    };

    /// Over the logarithm of frequency: that of the parabola through the node and its neighbours, at an end through the
    /// first or last three nodes.
    std::complex<double> slope(const Places& places, std::size_t node) const {
        if (value.size() < 3) return (value[1] - value[0]) / (places(1) - places(0));
        const std::size_t middle = std::clamp<std::size_t>(node, 1, value.size() - 2);
        const double before = places(middle) - places(middle - 1), after = places(middle + 1) - places(middle);
        const std::complex<double> left = (value[middle] - value[middle - 1]) / before,
                                   right = (value[middle + 1] - value[middle]) / after;
        const std::complex<double> bend = (right - left) / (before + after);  // half the second derivative
        return node < middle ? left - before * bend : node > middle ? right + after * bend : left + before * bend;
    }
};

}  // namespace railpem::lanes

#pragma once
// The hat of one node of a spline over wavelength, as frequencies see it at a speed.

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace railpem::diagnosis {

/// A node's share in the logarithm of a power, by frequency.
class NodeWeight {
  public:
    /// Of all wavelengths together where `node` is negative. `wavelengths_m`: nodes, increasing.
    NodeWeight(const std::vector<double>& wavelengths_m, int node, double speed_m_per_s) : speed_(speed_m_per_s) {
        if (node < 0) return;
        const auto i = static_cast<std::size_t>(node);
        own_ = wavelengths_m[i];
        if (i > 0) shorter_ = wavelengths_m[i - 1];
        if (i + 1 < wavelengths_m.size()) longer_ = wavelengths_m[i + 1];
    }

    double operator()(double frequency_hz) const {
        const double wavelength = speed_ / frequency_hz;
        const double next = wavelength < own_ ? shorter_ : longer_;
        if (own_ == 0.0 || next == 0.0) return 1.0;
        const double weight = 1.0 - std::log(wavelength / own_) / std::log(next / own_);
        return weight > 0.0 ? weight : 0.0;
    }

    double from_hz() const { return longer_ > 0.0 ? speed_ / longer_ : 0.0; }
    double to_hz() const { return shorter_ > 0.0 ? speed_ / shorter_ : std::numeric_limits<double>::infinity(); }

  private:
    double speed_, own_ = 0.0, shorter_ = 0.0, longer_ = 0.0;  ///< m/s, m; 0 where there is none
};

}  // namespace railpem::diagnosis

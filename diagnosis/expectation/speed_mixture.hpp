#pragma once
// The speeds at which the windows of a record were run, and what they do to the coherence between wheels.

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "recordings/estimates/averages.hpp"
#include "recordings/estimates/track_path.hpp"

namespace railpem::diagnosis {

/// A record at a speed v(t) that changes slowly beside a window: a wave n of the irregularity is at the frequency
/// n·v(t) under every wheel, and wheel j meets it with the phase −2πn·d_j whatever the speed. At a frequency f the
/// estimator therefore sees, averaged over the times of its windows, Σ_t w_t·S(f/v_t)/v_t·e^{−2πi·f·(d_j − d_l)/v_t}
/// between two wheels: the characteristic function of the slowness 1/v, weighted by the power of the windows. Exact to
/// the second moment of the frequency within a window, for ∫|w'|² + ∫w²φ'² is that of both.
///
/// δ is the slowness over that of the reference speed, less one; φ_k(x) = E[δ^k·e^{−2πi·x·δ}] with x = f·(d_j − d_l)/v
/// the cycles between two wheels.
class SpeedMixture {
  public:
    /// Speeds of a path over segments of a record that begin at `from_s`, in s; `reference_m_per_s`: v above;
    /// `error`: relative, by which a speed of the path is off by chance, taken off its spread. `most_cycles`: largest x
    /// that will be asked for.
    SpeedMixture(const recordings::TrackPath& path, const recordings::Segmentation& segments, double sampling_rate_hz,
                 double from_s, double reference_m_per_s, double error, double most_cycles);

    /// φ_0 and φ_1 at x ≥ 0; those at −x are the conjugates.
    std::array<std::complex<double>, 2> at(double cycles) const;

    /// A few deviations δ of equal weight that stand for all.
    const std::vector<double>& nodes() const { return nodes_; }
    double least() const { return nodes_.front(); }
    double most() const { return nodes_.back(); }

  private:
    double step_ = 1.0;
    std::vector<std::array<std::complex<double>, 2>> table_;
    std::vector<double> nodes_;
};

using WheelCoherence = std::array<std::array<std::complex<double>, 4>, 4>;

/// Cholesky factor of the coherence matrix of four wheels, lower, row by row: e_j·factor[j][r] are the amplitudes of
/// rank r under wheel j of a source whose amplitudes are e_j. `slope`: d ln S/d ln f of its power at f.
WheelCoherence wheel_coherence(const SpeedMixture& mixture, const std::vector<double>& wheels_m, double speed_m_per_s,
                               double frequency_hz, double slope);

}  // namespace railpem::diagnosis

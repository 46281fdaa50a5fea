#pragma once

#include <cstdint>
#include <vector>

#include "pem/source_parameters.hpp"

namespace railpem::simulate {

/// Finite impulse response from the marching rate to the sampling rate: anti-alias filter, gain, mounting resonance and
/// delay of one channel in one set of taps, designed in the frequency domain.
///
/// Anti-alias: linear phase, Kaiser window (Kaiser 1974), flat to 0.45 of the sampling rate within 1e-4, below −80 dB
/// from 0.5 of it on; its own delay is taken out. Resonance: 1/(1 − (f/f_m)² + 2iζf/f_m).
struct ChannelFilter {
    std::vector<double> taps;  ///< tap i weighs the marching sample `before − i` steps from the output's own time
    int before = 0;  ///< marching steps by which the newest sample lies after the output's time; may be negative

    int reach_back() const {
        return static_cast<int>(taps.size()) - 1 - before;
    }  ///< steps by which the oldest lies before it
};

/// `ratio`: marching steps per sample.
ChannelFilter make_filter(const pem::SensorParameters& sensor, double sampling_rate_hz, int ratio);

/// Keeps the last marching samples of one channel and gives filtered ones.
class FilteredChannel {
  public:
    explicit FilteredChannel(ChannelFilter filter) : filter_(std::move(filter)), kept_(2 * filter_.taps.size(), 0.0) {}

    void push(double value);
    /// Output for the time of the newest sample minus `before` steps.
    double output() const;
    const ChannelFilter& filter() const { return filter_; }

  private:
    ChannelFilter filter_;
    std::vector<double> kept_;  ///< every sample twice, a length apart, so that the last ones are always contiguous
    std::size_t next_ = 0;
};

/// Gaussian noise of the rms from 0.5 Hz to half the sampling rate with S(f) ∝ 1 + corner/f: white above the corner,
/// 1/f below it.
std::vector<double> draw_pink_noise(double rms, double corner_hz, std::size_t samples, double sampling_rate_hz,
                                    std::uint64_t seed);

/// Gaussian noise with the sensor's rms and slope between 0.5 Hz and half the sampling rate; S(f) ∝ (f/10
/// Hz)^(slope/3.01).
std::vector<double> draw_noise(const pem::SensorParameters& sensor, std::size_t samples, double sampling_rate_hz,
                               std::uint64_t seed);

}  // namespace railpem::simulate

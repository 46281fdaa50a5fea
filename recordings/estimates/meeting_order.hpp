#pragma once
// In which order channels meet the same track, whatever their description says.

#include <cstddef>
#include <vector>

#include "recordings/estimates/wheelbase_speed.hpp"

namespace railpem::recordings {

/// How the order is looked for.
struct MeetingOptions {
    double from_hz = 5.0;  ///< as in RunningSpeedOptions
    double to_hz = 90.0;
    double window_s = 1.5;  ///< of one channel; of the other what it shows in the longest delay before and after
    double hop_s = 1.0;     ///< longer where a record has more than `most_windows`
    double most_acceleration = 1.0;  ///< m/s², as in RunningSpeedOptions
    std::size_t most_windows = 64;
    SpeedRange range;
};

/// Whitened cross-correlations of all pairs of channels in windows along a record, over delays of both signs.
struct MeetingCorrelations {
    std::size_t channels = 0, windows = 0;
    double rate_hz = 0.0;  ///< of the delays
    double hop_s = 0.0;
    std::size_t reach = 0;  ///< delays from −reach to reach, in 1/rate_hz
    std::vector<std::vector<float>>
        correlation;  ///< per pair (first < second): [window][delay]; second later: positive

    /// How alike two channels are in a window when `second` is later by `delay_s`; 0 beyond the reach.
    double at(std::size_t first, std::size_t second, std::size_t window, double delay_s) const;
};

/// `samples`: without missing ones; `longest_m`: the largest distance between two places.
MeetingCorrelations meeting_correlations(const std::vector<std::vector<double>>& samples, double sampling_rate_hz,
                                         double longest_m, const MeetingOptions& options = {});

/// How well channels at `places_m` (front positive) meet one track, and the speeds at which they do it best.
struct MeetingScore {
    double correlation = 0.0;           ///< mean over pairs and windows along the best path of speeds
    std::vector<double> speed_m_per_s;  ///< per window
};
MeetingScore meeting_score(const MeetingCorrelations& correlations, const std::vector<double>& places_m,
                           const MeetingOptions& options = {});

/// The mean over pairs and windows at speeds that are known.
double correlation_at(const MeetingCorrelations& correlations, const std::vector<double>& places_m,
                      const std::vector<double>& speed_m_per_s);

}  // namespace railpem::recordings

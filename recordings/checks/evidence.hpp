#pragma once
// What the checks look at, computed once.

#include <optional>
#include <string>
#include <vector>

#include "recordings/checks/inspection_context.hpp"
#include "recordings/checks/true_places.hpp"
#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/estimates/running_speed.hpp"
#include "recordings/estimates/spectral_lines.hpp"
#include "recordings/estimates/wheelbase_speed.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings::checks {

/// A stretch of the record, s.
struct Stretch {
    double from_s = 0.0, to_s = 0.0;
};

/// Lines and delays are looked for up to here. Above, no line of a vehicle on its track has a name, and axle boxes
/// share nothing: wheels filter waves shorter than the contact (2 kHz is 1 cm at 20 m/s).
inline constexpr double highest_line_hz = 2000.0;

/// All of it stands in the order of the series' channels, each at its true place.
struct Evidence {
    const Recording& recording;
    const InspectionContext& context;
    const CrossSpectra* spectra = nullptr;         ///< 2 s windows; null when the record has no complete window
    std::vector<std::vector<double>> detrended;    ///< per channel, missing samples 0
    std::vector<std::vector<SpectralLine>> lines;  ///< per channel
    std::vector<Stretch> stops;                    ///< in which the train stands
    Stretch moving;                                ///< the longest stretch between stops
    std::optional<RunningSpeed> running;           ///< over `moving`, where channels say it; time 0 at its beginning
    std::vector<PairDelay> delays;                 ///< between axle boxes and between bogies; empty without a geometry
    std::optional<WheelbaseSpeed> speed;           ///< from the delays
    /// What lines and delays are looked for in: `detrended`, thinned where it is sampled much faster than they need.
    /// Empty: not thinned.
    std::vector<std::vector<double>> thinned;
    double thinned_rate_hz = 0.0;

    const TimeSeries& series() const { return recording.series; }
    /// Samples for lines and delays, and their rate.
    const std::vector<double>& slow(std::size_t channel) const {
        return thinned.empty() ? detrended[channel] : thinned[channel];
    }
    double slow_rate_hz() const { return thinned.empty() ? series().sampling_rate_hz : thinned_rate_hz; }
    const std::string& name(std::size_t channel) const { return series().channels[channel].description.name; }
};

/// Everything that the checks share. `recording`: with the places of `places`; all three must outlive the result.
Evidence gather_evidence(const Recording& recording, const InspectionContext& context, const CrossSpectra* spectra,
                         std::vector<std::vector<double>> detrended, const TruePlaces& places);

}  // namespace railpem::recordings::checks

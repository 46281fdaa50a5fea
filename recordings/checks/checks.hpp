#pragma once
// The checks of a recording. Each looks for one kind of fault (or a few that share their arithmetic) and returns what
// it found. Thresholds are chosen so that a sound record raises a false alarm in far less than 1 % of all cases per
// check; the verification tests count them on 500 sound records.

#include <optional>
#include <string>
#include <vector>

#include "recordings/checks/inspection_context.hpp"
#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/estimates/spectral_lines.hpp"
#include "recordings/estimates/wheelbase_speed.hpp"
#include "recordings/fault.hpp"

namespace railpem::recordings::checks {

/// Lines and delays are looked for up to here. Above, no line of a vehicle on its track has a name, and axle boxes
/// share nothing: wheels filter waves shorter than the contact (2 kHz is 1 cm at 20 m/s).
inline constexpr double highest_line_hz = 2000.0;

inline constexpr double false_alarm = 1e-6;  ///< of a test that stands for itself, in a sound record

/// What the checks look at, computed once.
struct Evidence {
    const Recording& recording;
    const InspectionContext& context;
    const CrossSpectra* spectra = nullptr;         ///< 2 s windows; null when the record has no complete window
    std::vector<std::vector<double>> detrended;    ///< per channel, missing samples 0
    std::vector<std::vector<SpectralLine>> lines;  ///< per channel
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

/// Missing samples (NaN), values that stand still, constant channels, few digits, clipping.
void check_samples(const Evidence& evidence, std::vector<Fault>& faults);

/// Clipping that a filter has smoothed since: the highest peaks are more alike than those of a random channel (mean
/// excess over a high threshold, Rice's peaks). Needs some thousand peaks; a channel of strong lines is left out.
void check_soft_clipping(const Evidence& evidence, std::vector<Fault>& faults);

/// Mean and drift, by the t test on means of 16 parts of the record; 1/f noise, by the slope of the log-periodogram
/// below 0.8 Hz (Geweke & Porter-Hudak 1983).
void check_offset(const Evidence& evidence, std::vector<Fault>& faults);

/// Unit wrong by 9.81, 1000 or both: against the prediction when there is one, and among channels at like places.
void check_unit(const Evidence& evidence, std::vector<Fault>& faults);

/// Duplicated channels, by correlation; swapped channels, by the order of the delays and by roughness above 20 Hz.
void check_channels(const Evidence& evidence, std::vector<Fault>& faults);

/// Inverted channels, by the signs of delayed copies, of the mean wheel and its bogie, and of the body's ends and its
/// centre.
void check_polarity(const Evidence& evidence, std::vector<Fault>& faults);

/// A channel late or early by the same time at every speed: what is left of the delays after slowness × distance.
void check_timing(const Evidence& evidence, std::vector<Fault>& faults);

/// Lines at 50, 60 or 16 2/3 Hz and multiples.
void check_mains(const Evidence& evidence, std::vector<Fault>& faults);

/// A spectrum that has not fallen off before half the sampling rate.
void check_aliasing(const Evidence& evidence, std::vector<Fault>& faults);

/// Times in the file: jitter, gaps, a rate other than stated; mileage against speed.
void check_sampling(const Evidence& evidence, std::vector<Fault>& faults);

/// Levels that differ between parts of the record (Bartlett's test per octave), speed changes, stops, a record too
/// short.
void check_stationarity(const Evidence& evidence, std::vector<Fault>& faults);

/// Impacts: prediction errors of an autoregressive model beyond what a Gaussian record has.
void check_impacts(const Evidence& evidence, std::vector<Fault>& faults);

}  // namespace railpem::recordings::checks

#pragma once
// The checks of a recording. Each looks for one kind of fault (or a few that share their arithmetic) and returns what
// it found. Thresholds are chosen so that a sound record raises a false alarm in far less than 1 % of all cases per
// check; the verification tests count them on 500 sound records.

#include <vector>

#include "recordings/checks/evidence.hpp"
#include "recordings/checks/false_alarm.hpp"
#include "recordings/fault.hpp"

namespace railpem::recordings::checks {

/// Missing samples (NaN), values that stand still, constant channels, few digits, clipping.
void check_samples(const Evidence& evidence, std::vector<Fault>& faults);

/// Clipping that a filter has smoothed since: the highest peaks are more alike than those of a random channel (mean
/// excess over a high threshold, Rice's peaks). Needs some thousand peaks; a channel of strong lines is left out.
void check_soft_clipping(const Evidence& evidence, std::vector<Fault>& faults);

/// Mean and drift, by the t test on means of 16 parts of the record; 1/f noise, by the slope of the log-periodogram
/// below 0.8 Hz (Geweke & Porter-Hudak 1983).
void check_offset(const Evidence& evidence, std::vector<Fault>& faults);

/// No signal above a frequency, where the case predicts one or in all channels at once: a low-pass filter.
void check_band_limit(const Evidence& evidence, std::vector<Fault>& faults);

/// Unit wrong by 9.81, 1000 or both, or another quantity: against the prediction when there is one, and among channels
/// at like places. A mistake that several channels share is told once.
void check_unit(const Evidence& evidence, std::vector<Fault>& faults);

/// Duplicated channels, by correlation; channels of wheel, bogie and body exchanged, by roughness above 20 Hz.
/// Exchanges among like channels are put right before (true_places()).
void check_channels(const Evidence& evidence, std::vector<Fault>& faults);

/// Inverted channels, by the signs of delayed copies, of the mean wheel and its bogie, and of the body's ends and its
/// centre.
void check_polarity(const Evidence& evidence, std::vector<Fault>& faults);

/// A channel whose clock runs faster or slower than the others': delays part by part, against one slowness in each
/// part.
void check_clock(const Evidence& evidence, std::vector<Fault>& faults);

/// A channel late or early by the same time at every speed: what is left of the delays after slowness × distance.
void check_timing(const Evidence& evidence, std::vector<Fault>& faults);

/// Lines at 50, 60 or 16 2/3 Hz and multiples.
void check_mains(const Evidence& evidence, std::vector<Fault>& faults);

/// A spectrum that has not fallen off before half the sampling rate.
void check_aliasing(const Evidence& evidence, std::vector<Fault>& faults);

/// Times in the file: jitter, gaps, a rate other than stated; mileage against speed.
void check_sampling(const Evidence& evidence, std::vector<Fault>& faults);

/// Stops, which the evidence holds.
void check_stops(const Evidence& evidence, std::vector<Fault>& faults);

/// Speed that changes, by a speed channel or by the delays; a stated speed against the delays, and what unit it may
/// have been taken for.
void check_speed(const Evidence& evidence, std::vector<Fault>& faults);

/// Levels that differ between parts of the record (Bartlett's test per octave), a record too short.
void check_stationarity(const Evidence& evidence, std::vector<Fault>& faults);

/// Impacts: prediction errors of an autoregressive model beyond what a Gaussian record has.
void check_impacts(const Evidence& evidence, std::vector<Fault>& faults);

}  // namespace railpem::recordings::checks

#pragma once
// What a recording holds and whether it can be trusted: one result, three writers (text, JSON, HTML).

#include <optional>
#include <string>
#include <vector>

#include "recordings/checks/inspection_context.hpp"
#include "recordings/estimates/band_levels.hpp"
#include "recordings/estimates/spectral_lines.hpp"
#include "recordings/estimates/wheel_orders.hpp"
#include "recordings/fault.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings {

/// One channel in figures.
struct ChannelInspection {
    ChannelDescription description;
    std::string unit_says;                     ///< unit of the numbers in the file, and who says so, in words
    double mean = 0.0, rms = 0.0, peak = 0.0;  ///< SI; rms and peak without mean and drift
    double kurtosis = 0.0;                     ///< 3 for a Gaussian channel
    double noise_rms = 0.0;          ///< incoherent with all other channels, 4 Hz to 0.4 f_s; NaN: cannot be told
    std::vector<double> psd;         ///< on InspectionReport::frequency_hz, SI²/Hz
    std::vector<double> incoherent;  ///< same grid, NaN where it cannot be told; empty when averages do not suffice
    std::vector<BandLevel> bands;
    std::vector<SpectralLine> lines;
    std::vector<std::string> line_names;  ///< per line, "" when it has none
};

/// Coherence of a pair of channels on the report's grid.
struct PairCoherence {
    std::string first, second;
    std::vector<double> coherence;
};

/// Levels of one channel over time and frequency.
struct Spectrogram {
    std::string channel;
    double window_s = 0.0, step_s = 0.0, bin_hz = 0.0;
    std::size_t times = 0, bins = 0;
    std::vector<float> level_db;  ///< [time][bin], re 1 SI²/Hz; NaN where a sample is missing
};

/// The speed along a record, and where it was read from.
struct SpeedAlong {
    double mean_m_per_s = 0.0, lowest_m_per_s = 0.0, highest_m_per_s = 0.0;
    std::string read_from;  ///< "delays", "speed channel" or "description"; "": not known
};

/// A frequency that has a name at the speed of the record.
struct NamedFrequency {
    double frequency_hz = 0.0;
    std::string name;
};

struct InspectionReport {
    std::string title, file;
    std::string start;  ///< date and time of the first sample as the data file says; empty: not said
    RecordingKind kind = RecordingKind::timeseries;
    double duration_s = 0.0, sampling_rate_hz = 0.0;
    std::size_t samples = 0;
    double stated_speed_m_per_s = 0.0, stated_speed_error_m_per_s = 0.0;  ///< 0: not stated
    double speed_m_per_s = 0.0, speed_error_m_per_s = 0.0;                ///< from the delays; 0: could not be told
    int speed_pairs = 0;
    std::optional<WheelOrders> wheel_orders;       ///< when enough lines are multiples of one rotation
    double averages = 0.0, coherence_limit = 1.0;  ///< of one bin; 5 % limit of the coherence of unrelated channels
    double interval_low_db = 0.0, interval_high_db = 0.0;  ///< 90 % interval of one bin
    std::vector<double> frequency_hz;
    std::vector<ChannelInspection> channels;
    std::vector<PairCoherence> coherences;
    std::vector<Spectrogram> spectrograms;
    std::vector<NamedFrequency> named_frequencies;
    std::vector<Fault> faults;             ///< errors first
    std::vector<std::string> not_checked;  ///< what could not be checked, and why
    std::vector<std::string> lacks, notes;
    std::vector<ChannelSpectrum> spectra;  ///< kinds psd and points
    MeasuredReceptance receptance;         ///< kind receptance
    MeasuredDecayRate decay_rate;          ///< kind decay-rate
    MeasuredIrregularity irregularity;     ///< that the recording brings, without the samples of its profile
    double profile_length_m = 0.0, profile_step_m = 0.0, profile_rms_m = 0.0;  ///< 0: not a profile; rms without mean
    SpeedAlong speed_along;
};

}  // namespace railpem::recordings

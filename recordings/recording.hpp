#pragma once
// What was read from a recording, in SI units, with nothing removed and nothing repaired.

#include <complex>
#include <string>
#include <vector>

#include "recordings/fault.hpp"
#include "recordings/measured_irregularity.hpp"
#include "recordings/recording_description.hpp"

namespace railpem::recordings {

/// One channel of a time series. Missing samples are NaN.
struct Channel {
    ChannelDescription description;
    std::vector<double> samples;  ///< m/s², m/s or m by description.quantity
    std::string unit_says;        ///< in words: unit of the numbers in the file, and who says so
};

/// Vibration channels sampled together, and the state of the train.
struct TimeSeries {
    double sampling_rate_hz = 0.0;
    double start_s = 0.0;  ///< of the first sample, from the beginning of the file
    std::vector<Channel> channels;
    std::vector<double> time_s;         ///< as in the file, per sample; empty when it has no time
    std::vector<double> speed_m_per_s;  ///< per sample; empty when there is no speed channel
    std::vector<double> mileage_m;      ///< per sample; empty when there is no mileage channel

    std::size_t size() const { return channels.empty() ? 0 : channels.front().samples.size(); }
    double duration_s() const { return sampling_rate_hz > 0.0 ? static_cast<double>(size()) / sampling_rate_hz : 0.0; }
};

/// A PSD without its time series: kinds psd and points. It says nothing of phases between channels.
struct ChannelSpectrum {
    ChannelDescription description;
    std::vector<double> frequency_hz;
    std::vector<double> psd;             ///< one-sided, SI unit of the quantity squared per Hz
    std::vector<double> standard_error;  ///< of psd; empty when not stated
    std::string unit_says;               ///< in words: unit of the numbers in the file, and who says so
};

/// Rail receptance without a vehicle, m/N.
struct MeasuredReceptance {
    std::vector<double> frequency_hz;
    std::vector<std::complex<double>> value_m_per_n;  ///< real and positive when only the magnitude is known
    bool has_phase = true;
};

/// Track decay rate per third-octave band.
struct MeasuredDecayRate {
    std::vector<double> centre_hz;
    std::vector<double> decay_rate_db_per_m;
    std::vector<double> standard_error_db_per_m;  ///< empty when not stated
};

/// A recording. Only the member of its kind is filled, and the irregularity where it is measured.
struct Recording {
    RecordingDescription description;
    std::string file;  ///< of the data
    TimeSeries series;
    std::vector<ChannelSpectrum> spectra;
    MeasuredReceptance receptance;
    MeasuredDecayRate decay_rate;
    MeasuredIrregularity irregularity;  ///< with any kind; nothing brought when the description names no file
    std::vector<std::string> lacks;     ///< what this kind of data cannot tell, in words
    std::vector<std::string> notes;     ///< what the reader saw and did not change: another encoding, …
    std::vector<Fault> contradictions;  ///< what the data file says against its description, or against itself
    std::string start;                  ///< date and time of the first sample as the file says; empty: not said
};

}  // namespace railpem::recordings

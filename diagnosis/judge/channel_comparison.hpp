#pragma once
// Recorded levels beside those of the stages of a diagnosis, as data.

#include <string>
#include <vector>

#include "diagnosis/effects/element.hpp"
#include "diagnosis/likelihood/likelihood_context.hpp"

namespace railpem::diagnosis {

/// The three stages of a diagnosis on the same recordings.
struct Stages {
    const Trial* believed = nullptr;
    const Predictions* believed_predictions = nullptr;
    const Trial* retuned = nullptr;
    const Predictions* retuned_predictions = nullptr;
    const Trial* diagnosed = nullptr;
    const Predictions* diagnosed_predictions = nullptr;
};

/// One of them.
enum class Stage { believed, retuned, diagnosed };

/// A band of a channel where the retuned case differs from the recording beyond chance.
struct Mismatch {
    std::string recording, channel;
    std::string other_channel;  ///< of a cross-spectrum; empty: the channel's own level
    double low_hz = 0.0, high_hz = 0.0;
    double level_db = 0.0;                 ///< recording over model
    double false_alarm_probability = 1.0;  ///< over all channels and bands together
    Element element = Element::body;
};

/// One channel of one recording: PSDs on a common grid of bins, in the channel's squared unit per Hz; of a recording
/// without time series its levels.
struct ChannelComparison {
    std::string recording, channel;
    double speed_m_per_s = 0.0;
    /// what `measured` and the models are, with the unit, as in a column
    std::string quantity = "psd_m2_per_s4_per_hz";
    std::vector<double> frequency_hz;
    std::vector<double> measured, low, high;  ///< with the 90 % band of the estimate
    std::vector<double> believed, retuned, diagnosed;
    /// third octaves: levels of recording over model, dB; NaN where the recording says nothing
    std::vector<double> band_centre_hz;
    std::vector<double> band_believed_db, band_retuned_db, band_diagnosed_db;
};

}  // namespace railpem::diagnosis

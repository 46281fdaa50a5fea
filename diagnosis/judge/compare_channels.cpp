#include "diagnosis/judge/compare_channels.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/judge/compare_scalars.hpp"
#include "diagnosis/likelihood/likelihood.hpp"
#include "recordings/estimates/confidence.hpp"
#include "spectra/third_octaves.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kMostNoise = 0.5;  ///< a band that is noise to more than this says nothing
constexpr double kReported = 0.01;  ///< false-alarm probability of what is reported
constexpr std::size_t kMostReported = 12;

std::vector<double> channel_psd(const Trial& trial, const Predictions& predictions, const Observation& observation,
                                std::size_t o, std::size_t channel) {
    std::vector<double> psd;
    const std::size_t size = observation.channels.size();
    for (std::size_t bin = 0; bin < observation.bins(); ++bin)
        psd.push_back(predictions[o].values[bin * size * size + channel * (size + 1)].real() +
                      noise_at(trial, o, channel, observation.frequency(bin)));
    return psd;
}

std::vector<double> measured_psd(const MeasuredSpectra& data, std::size_t size, std::size_t channel) {
    std::vector<double> psd;
    for (std::size_t bin = 0; bin * size * size < data.values.size(); ++bin)
        psd.push_back(data.values[bin * size * size + channel * (size + 1)].real());
    return psd;
}

/// Bins of a band, first and one past the last.
std::pair<std::size_t, std::size_t> bins_of(const Observation& observation, const spectra::ThirdOctaveBand& band) {
    const double width = observation.kernel.bin_hz();
    const long first = static_cast<long>(std::ceil(band.low_hz / width)) - static_cast<long>(observation.first_bin());
    const long last = static_cast<long>(std::ceil(band.high_hz / width)) - static_cast<long>(observation.first_bin());
    const long most = static_cast<long>(observation.bins());
    return {static_cast<std::size_t>(std::clamp(first, 0L, most)),
            static_cast<std::size_t>(std::clamp(last, 0L, most))};
}

double sum_between(const std::vector<double>& values, std::pair<std::size_t, std::size_t> bins) {
    double sum = 0.0;
    for (std::size_t i = bins.first; i < bins.second; ++i) sum += values[i];
    return sum;
}

double level(double measured, double model) {
    return 10.0 * std::log10(measured / model);
}

ChannelComparison compare(const Stages& stages, const Observation& observation, std::size_t o, std::size_t c,
                          Part part) {
    const MeasuredSpectra& data = measured(observation, part);
    ChannelComparison result{.recording = observation.name,
                             .channel = observation.channel_names[c],
                             .speed_m_per_s = observation.speed_m_per_s};
    for (std::size_t bin = 0; bin < observation.bins(); ++bin)
        result.frequency_hz.push_back(observation.frequency(bin));
    result.measured = measured_psd(data, observation.channels.size(), c);
    const recordings::Interval interval = recordings::spectrum_interval(std::max(1.0, data.averages));
    for (const double value : result.measured) {
        result.low.push_back(value * interval.low);
        result.high.push_back(value * interval.high);
    }
    result.believed = channel_psd(*stages.believed, *stages.believed_predictions, observation, o, c);
    result.retuned = channel_psd(*stages.retuned, *stages.retuned_predictions, observation, o, c);
    result.diagnosed = channel_psd(*stages.diagnosed, *stages.diagnosed_predictions, observation, o, c);
    for (const spectra::ThirdOctaveBand& band :
         spectra::third_octave_bands(observation.expectation.low_hz, observation.expectation.high_hz)) {
        const auto bins = bins_of(observation, band);
        if (bins.second < bins.first + 2) continue;
        const double whole = sum_between(result.measured, bins);
        double noise = 0.0;
        for (std::size_t bin = bins.first; bin < bins.second; ++bin)
            noise += noise_at(*stages.diagnosed, o, c, observation.frequency(bin));
        const bool speaks = noise < kMostNoise * whole;
        result.band_centre_hz.push_back(band.nominal_hz);
        result.band_believed_db.push_back(speaks ? level(whole, sum_between(result.believed, bins)) : kNaN);
        result.band_retuned_db.push_back(speaks ? level(whole, sum_between(result.retuned, bins)) : kNaN);
        result.band_diagnosed_db.push_back(speaks ? level(whole, sum_between(result.diagnosed, bins)) : kNaN);
    }
    return result;
}

/// Two-sided probability of a mean of `degrees`/2 unit exponentials being as far from 1 (Wilson–Hilferty).
double two_sided(double mean, double degrees) {
    const double variance = 2.0 / (9.0 * degrees);
    const double z = (std::cbrt(mean) - (1.0 - variance)) / std::sqrt(variance);
    return std::min(1.0, 2.0 * recordings::normal_exceeded(std::abs(z)));
}

/// What every bin says of every channel: own level, and variance given all others, each over what the model expects.
struct BinRatios {
    std::vector<double> measured, model, conditional;  ///< [bin][channel]
};

BinRatios bin_ratios(const Trial& trial, const Predictions& predictions, const Observation& observation, std::size_t o,
                     const MeasuredSpectra& data) {
    BinRatios ratios;
    const std::size_t size = observation.channels.size();
    const long n = static_cast<long>(size);
    for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
        const Eigen::MatrixXcd model = complete_prediction(trial, observation, o, predictions[o], bin);
        const Eigen::MatrixXcd inverse = model.llt().solve(Eigen::MatrixXcd::Identity(n, n));
        const Eigen::Map<const Eigen::MatrixXcd> estimate(&data.values[bin * size * size], n, n);
        const Eigen::MatrixXcd sandwich = inverse * estimate * inverse;
        for (long c = 0; c < n; ++c) {
            ratios.measured.push_back(estimate(c, c).real());
            ratios.model.push_back(model(c, c).real());
            ratios.conditional.push_back(sandwich(c, c).real() / inverse(c, c).real());
        }
    }
    return ratios;
}

}  // namespace

std::vector<ChannelComparison> compare_channels(const Stages& stages, const std::vector<Observation>& observations,
                                                Part part) {
    std::vector<ChannelComparison> channels;
    for (std::size_t o = 0; o < observations.size(); ++o) {
        if (observations[o].scalar) {
            compare_scalars(stages, observations[o], o, part, channels);
            continue;
        }
        for (std::size_t c = 0; c < observations[o].channels.size(); ++c)
            channels.push_back(compare(stages, observations[o], o, c, part));
    }
    return channels;
}

double rms_db(const std::vector<ChannelComparison>& channels, Stage stage) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const ChannelComparison& channel : channels) {
        const std::vector<double>& levels = stage == Stage::believed  ? channel.band_believed_db
                                            : stage == Stage::retuned ? channel.band_retuned_db
                                                                      : channel.band_diagnosed_db;
        for (const double value : levels)
            if (std::isfinite(value)) sum += value * value, ++count;
    }
    return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

std::vector<Mismatch> mismatches(const Trial& trial, const Predictions& predictions,
                                 const std::vector<Observation>& observations, Part part) {
    Trial sound = trial;
    for (double& floor : sound.floor) floor = std::min(floor, kBeliefs.sound_floor);
    std::vector<Mismatch> found;
    double tests = 0.0;
    for (std::size_t o = 0; o < observations.size(); ++o) {
        const Observation& observation = observations[o];
        if (observation.scalar) {
            tests += scalar_mismatches(sound, predictions, observation, o, part, found);
            continue;
        }
        const MeasuredSpectra& data = measured(observation, part);
        const std::size_t size = observation.channels.size();
        const BinRatios ratios = bin_ratios(sound, predictions, observation, o, data);
        for (const spectra::ThirdOctaveBand& band :
             spectra::third_octave_bands(observation.expectation.low_hz, observation.expectation.high_hz)) {
            const auto bins = bins_of(observation, band);
            if (bins.second < bins.first + 2) continue;
            for (std::size_t c = 0; c < size; ++c) {
                double whole = 0.0, model = 0.0, squares = 0.0, conditional = 0.0;
                const double count = static_cast<double>(bins.second - bins.first);
                for (std::size_t bin = bins.first; bin < bins.second; ++bin) {
                    const std::size_t i = bin * size + c;
                    whole += ratios.measured[i];
                    model += ratios.model[i];
                    squares += ratios.model[i] * ratios.model[i];
                    conditional += ratios.conditional[i] / count;
                }
                const double own = two_sided(whole / model, 2.0 * data.averages * model * model / squares);
                const double given_others = two_sided(conditional, 2.0 * data.averages * count);
                tests += 2.0;
                found.push_back({.recording = observation.name,
                                 .channel = observation.channel_names[c],
                                 .low_hz = band.low_hz,
                                 .high_hz = band.high_hz,
                                 .level_db = level(whole, model),
                                 .false_alarm_probability = std::min(own, given_others)});
            }
        }
    }
    for (Mismatch& mismatch : found)
        mismatch.false_alarm_probability = std::min(1.0, mismatch.false_alarm_probability * tests);
    std::erase_if(found, [](const Mismatch& mismatch) { return mismatch.false_alarm_probability > kReported; });
    std::stable_sort(found.begin(), found.end(), [](const Mismatch& a, const Mismatch& b) {
        return a.false_alarm_probability != b.false_alarm_probability
                   ? a.false_alarm_probability < b.false_alarm_probability
                   : std::abs(a.level_db) > std::abs(b.level_db);
    });
    if (found.size() > kMostReported) found.resize(kMostReported);
    return found;
}

}  // namespace railpem::diagnosis

#include "recordings/estimates/wheelbase_speed.hpp"

#include <algorithm>
#include <cmath>

#include "recordings/estimates/cross_spectra.hpp"

namespace railpem::recordings {
namespace {

double relative_error(const PairDelay& pair) {
    // Below a hundredth of a percent the ripple of the phase, not the noise, decides: no pair is believed better than
    // that.
    return std::max(pair.delay.standard_error_s / std::abs(pair.delay.seconds), 1e-4);
}

struct Mean {
    double slowness = 0.0, error = 0.0, chi_squared = 0.0;
};

Mean weighted_mean(const std::vector<PairDelay>& pairs, const std::vector<bool>& used) {
    double sum = 0.0, weights = 0.0, chi = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (used[i]) {
            const double slowness = pairs[i].delay.seconds / pairs[i].distance_m,
                         weight = std::pow(slowness * relative_error(pairs[i]), -2);
            sum += weight * slowness;
            weights += weight;
        }
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (used[i]) {
            const double slowness = pairs[i].delay.seconds / pairs[i].distance_m;
            chi += std::pow((slowness - sum / weights) / (slowness * relative_error(pairs[i])), 2);
        }
    return {sum / weights, 1.0 / std::sqrt(weights), chi};
}

}  // namespace

bool meet_alike(const ChannelDescription& a, const ChannelDescription& b) {
    return a.location == b.location && a.quantity == b.quantity && a.index != b.index &&
           (a.side == b.side || a.side == Side::unstated || b.side == Side::unstated);
}

std::optional<double> place_along(const ChannelDescription& channel, const VehicleGeometry& geometry) {
    if (channel.location == Location::wheel && channel.index >= 1 && channel.index <= 4)
        return geometry.wheels_m[static_cast<std::size_t>(channel.index - 1)];
    if (channel.location == Location::bogie && channel.index >= 1 && channel.index <= 2)
        return geometry.bogies_m[static_cast<std::size_t>(channel.index - 1)];
    return std::nullopt;
}

std::optional<double> distance_between(const ChannelDescription& first, const ChannelDescription& second,
                                       const VehicleGeometry& geometry) {
    const auto a = place_along(first, geometry), b = place_along(second, geometry);
    if (!a || !b) return std::nullopt;
    return *a - *b;
}

std::vector<PairDelay> wheelbase_delays(const TimeSeries& series, const VehicleGeometry& geometry,
                                        const SpeedRange& range) {
    std::vector<PairDelay> pairs;
    std::vector<std::vector<double>> samples;
    for (const Channel& channel : series.channels) {
        samples.push_back(without_trend(channel.samples));
        for (double& value : samples.back())
            if (!std::isfinite(value)) value = 0.0;  // here a gap only lowers the correlation
    }
    // Every pair is looked at over the delays of the longest one, on both sides of zero: channels that were swapped lag
    // by another time, or the wrong way.
    double farthest = 0.0;
    for (const Channel& a : series.channels)
        for (const Channel& b : series.channels)
            if (const auto distance = distance_between(a.description, b.description, geometry);
                distance && meet_alike(a.description, b.description))
                farthest = std::max(farthest, *distance);
    const double longest = farthest / range.least_m_per_s;
    for (std::size_t i = 0; i < samples.size(); ++i)
        for (std::size_t j = 0; j < samples.size(); ++j) {
            const ChannelDescription &a = series.channels[i].description, &b = series.channels[j].description;
            const auto distance = distance_between(a, b, geometry);
            if (!distance || *distance <= 0.0 || !meet_alike(a, b)) continue;
            PairDelay pair{i, j, *distance,
                           estimate_delay(samples[i], samples[j], series.sampling_rate_hz,
                                          {.least_s = -longest, .most_s = longest})};
            if (pair.delay.found && std::abs(pair.delay.seconds) >= 0.5 / series.sampling_rate_hz)
                pairs.push_back(pair);
        }
    return pairs;
}

std::optional<WheelbaseSpeed> wheelbase_speed(std::vector<PairDelay> pairs) {
    std::vector<bool> used;
    for (const PairDelay& pair : pairs) used.push_back(pair.delay.seconds > 0.0);
    auto count = std::count(used.begin(), used.end(), true);
    if (count == 0) return std::nullopt;
    Mean mean = weighted_mean(pairs, used);
    while (count > 2 && mean.chi_squared > 25.0) {  // five standard errors
        std::size_t worst = 0;
        double least = mean.chi_squared;
        for (std::size_t i = 0; i < pairs.size(); ++i)
            if (used[i]) {
                std::vector<bool> without = used;
                without[i] = false;
                const double chi = weighted_mean(pairs, without).chi_squared;
                if (chi < least) {
                    least = chi;
                    worst = i;
                }
            }
        if (least >= mean.chi_squared) break;
        used[worst] = false;
        --count;
        mean = weighted_mean(pairs, used);
    }
    const double inflation =
        count > 1 ? std::sqrt(std::max(1.0, mean.chi_squared / static_cast<double>(count - 1))) : 1.0;
    WheelbaseSpeed result;
    result.speed_m_per_s = 1.0 / mean.slowness;
    result.standard_error_m_per_s = inflation * mean.error / (mean.slowness * mean.slowness);
    result.pairs = std::move(pairs);
    result.pairs_used = static_cast<int>(count);
    return result;
}

}  // namespace railpem::recordings

#include "diagnosis/findings/imperfections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/fit/interval.hpp"
#include "diagnosis/likelihood/whitened_bin.hpp"

namespace railpem::diagnosis {

namespace {

std::string percent_words(double share) {
    const double percent = 100.0 * share;
    return percent >= 0.001 ? fmt::format("{:.2g} %", percent) : std::string("less than 0.001 %");
}

/// Mean of the logarithm over the nodes, and its deviation with all that the fit knows of them together.
void add_met_alone(const Fit& fit, std::vector<Imperfection>& result) {
    std::vector<std::size_t> nodes;
    for (std::size_t u = 0; u < fit.unknowns.size(); ++u)
        if (fit.unknowns[u].kind == UnknownKind::met_alone) nodes.push_back(u);
    if (nodes.empty()) return;
    const auto count = static_cast<double>(nodes.size());
    double mean = 0.0, variance = 0.0, least = 0.0, most = -1e300;
    for (const std::size_t i : nodes) {
        mean += fit.values[i] / count;
        least = std::min(least, fit.values[i]);
        most = std::max(most, fit.values[i]);
        for (const std::size_t j : nodes)
            variance += fit.covariance(static_cast<long>(i), static_cast<long>(j)) / (count * count);
    }
    const double reach = kNinety * std::sqrt(std::max(0.0, variance));
    result.push_back({.where = "wheel",
                      .channel = {},
                      .share_of_power = std::exp(mean),
                      .low = std::exp(mean - reach),
                      .high = std::exp(mean + reach),
                      .says = fmt::format("{} of the irregularity's power is met by each wheel alone ({} to {}, by "
                                          "wavelength).",
                                          percent_words(std::exp(mean)), percent_words(std::exp(least)),
                                          percent_words(std::exp(most)))});
}

/// Power of a channel over the band that nothing else shares, of all its power.
double own_share(const Fit& fit, const Observation& observation, std::size_t o, std::size_t c) {
    const ExpectedSpectra& predicted = fit.predictions[o];
    const std::size_t size = predicted.channels, group = floor_group(observation.channels[c].response);
    double own = 0.0, all = 0.0;
    for (std::size_t b = 0; b < predicted.bins(); ++b) {
        const double power = predicted.values[b * size * size + c * (size + 1)].real();
        const double beside = power * floors_at(fit.trial, observation.frequency(b), 0.0)[group] +
                              noise_at(fit.trial, o, c, observation.frequency(b));
        own += beside;
        all += power + beside;
    }
    return all > 0.0 ? own / all : 0.0;
}

std::string calibration_words(const Fit& fit, const std::string& channel, const std::string& recording) {
    std::size_t u = 0;
    if (!fit.find("calibration of " + channel + " in " + recording, &u)) return "";
    const double gain = 50.0 * fit.values[u], error = 50.0 * fit.deviation(u);  // of the amplitude, percent
    return fmt::format(" It reads {:.1f} % too {} (± {:.1f}).", std::abs(gain), gain < 0.0 ? "low" : "high", error);
}

}  // namespace

std::vector<Imperfection> imperfections(const Fit& fit, const std::vector<Observation>& observations) {
    std::vector<Imperfection> result;
    add_met_alone(fit, result);
    for (std::size_t o = 0; o < observations.size(); ++o) {
        const Observation& observation = observations[o];
        if (observation.scalar) continue;
        for (std::size_t c = 0; c < observation.channels.size(); ++c) {
            const std::string& channel = observation.channel_names[c];
            const double share = own_share(fit, observation, o, c);
            std::size_t u = 0;
            const bool known = fit.find(fmt::format("noise of {} in {}", channel, observation.name), &u) != nullptr;
            const double reach = known ? std::min(3.0, kNinety * fit.deviation(u)) : 0.0;
            const Imperfection own{
                .where = "sensor",
                .channel = channel,
                .share_of_power = share,
                .low = share * std::exp(-reach),
                .high = std::min(1.0, share * std::exp(reach)),
                .says = fmt::format("{} of what {} records no other sensor shares.", percent_words(share), channel) +
                        calibration_words(fit, channel, observation.name)};
            const auto same = std::find_if(result.begin(), result.end(),
                                           [&](const Imperfection& one) { return one.channel == channel; });
            if (same == result.end())
                result.push_back(own);
            else if (same->share_of_power < share)
                *same = own;
        }
    }
    return result;
}

}  // namespace railpem::diagnosis

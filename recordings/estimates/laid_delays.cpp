#include "recordings/estimates/laid_delays.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/estimates/interpolation.hpp"
#include "recordings/estimates/running_speed.hpp"

namespace railpem::recordings {

std::vector<double> laid_on_track(const std::vector<double>& samples, double rate, double place,
                                  const TrackPath& path) {
    std::vector<double> laid(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        laid[i] = sample_at(samples, rate * path.time_at(path.distance_at(static_cast<double>(i) / rate) - place));
    return laid;
}

std::vector<PairDelay> laid_delays(const TimeSeries& series, const VehicleGeometry& geometry, const TrackPath& path) {
    const double rate = series.sampling_rate_hz, mean = path.mean_m_per_s();
    std::vector<std::vector<double>> laid(series.channels.size());
    for (std::size_t i = 0; i < laid.size(); ++i)
        if (const auto place = place_along(series.channels[i].description, geometry)) {
            std::vector<double> samples = without_trend(series.channels[i].samples);
            for (double& value : samples)
                if (!std::isfinite(value)) value = 0.0;  // a gap only lowers the correlation
            laid[i] = laid_on_track(samples, rate, *place, path);
        }
    constexpr double kMostSkew_s = 1.0;  // loggers that start by hand differ by more, and then by many seconds
    const double highest_hz = RunningSpeedOptions{}.to_hz;  // above, wheels of one bogie hear each other
    std::vector<PairDelay> pairs;
    for (std::size_t i = 0; i < laid.size(); ++i)
        for (std::size_t j = 0; j < laid.size(); ++j) {
            const ChannelDescription &a = series.channels[i].description, &b = series.channels[j].description;
            const auto distance = distance_between(a, b, geometry);
            if (!distance || *distance <= 0.0 || !meet_alike(a, b)) continue;
            PairDelay pair{i, j, *distance,
                           estimate_delay(laid[i], laid[j], rate,
                                          {.least_s = -kMostSkew_s, .most_s = kMostSkew_s, .to_hz = highest_hz})};
            pair.delay.seconds += *distance / mean;
            if (pair.delay.found) pairs.push_back(pair);
        }
    return pairs;
}

}  // namespace railpem::recordings

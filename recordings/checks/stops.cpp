#include "recordings/checks/stops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "recordings/checks/checks.hpp"

namespace railpem::recordings::checks {
namespace {

/// The channels of the place that tells a stop best.
std::vector<std::size_t> telling_channels(const TimeSeries& series) {
    std::vector<std::size_t> members;
    for (const Location wanted : {Location::wheel, Location::bogie, Location::none, Location::body})
        if (members.empty())
            for (std::size_t i = 0; i < series.channels.size(); ++i)
                if (series.channels[i].description.location == wanted) members.push_back(i);
    return members;
}

/// Sum of squares about the mean of a stretch: a sensor that drifts while the train stands is quiet all the same.
double scatter_of(const std::vector<double>& samples, std::size_t begin, std::size_t count) {
    double sum = 0.0, square = 0.0;
    for (std::size_t n = begin; n < begin + count; ++n) {
        sum += samples[n];
        square += samples[n] * samples[n];
    }
    return std::max(0.0, square - sum * sum / static_cast<double>(count));
}

}  // namespace

std::vector<Stretch> stops_of(const TimeSeries& series, const std::vector<std::vector<double>>& detrended) {
    const std::vector<std::size_t> members = telling_channels(series);
    const auto step = static_cast<std::size_t>(0.5 * series.sampling_rate_hz);
    if (step < 8 || members.empty()) return {};
    std::vector<double> level, whole;
    for (const std::size_t member : members)
        whole.push_back(
            std::inner_product(detrended[member].begin(), detrended[member].end(), detrended[member].begin(), 1e-300));
    for (std::size_t begin = 0; begin + step <= series.size(); begin += step) {
        double sum = 0.0;
        for (std::size_t m = 0; m < members.size(); ++m)
            sum += scatter_of(detrended[members[m]], begin, step) / whole[m];
        level.push_back(std::sqrt(sum));
    }
    if (level.size() < 8) return {};
    std::vector<double> sorted = level;
    std::sort(sorted.begin(), sorted.end());
    // A twentieth of the usual level, for two seconds at least. The upper quartile is taken for usual: a record may
    // stand for half its time.
    const double quiet = 0.05 * sorted[3 * sorted.size() / 4];
    std::vector<Stretch> stops;
    for (std::size_t k = 0; k < level.size();) {
        const std::size_t begin = k;
        while (k < level.size() && level[k] < quiet) ++k;
        if (k - begin >= 4)
            stops.push_back({static_cast<double>(begin * step) / series.sampling_rate_hz,
                             static_cast<double>(k * step) / series.sampling_rate_hz});
        k = std::max(k, begin + 1);
    }
    return stops;
}

void check_stops(const Evidence& evidence, std::vector<Fault>& faults) {
    for (const Stretch& stop : evidence.stops) {
        Fault found;
        found.kind = FaultKind::stop;
        found.severity = Severity::error;
        found.says = fmt::format("from {:.1f} to {:.1f} s nothing moves: a stop, or an interruption of all channels",
                                 stop.from_s, stop.to_s);
        found.from_s = stop.from_s;
        found.to_s = stop.to_s;
        found.value = stop.to_s - stop.from_s;
        found.unit = "s";
        faults.push_back(std::move(found));
    }
}

}  // namespace railpem::recordings::checks

#include "diagnosis/observations/record_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace railpem::diagnosis {

namespace {

template <class T>
std::vector<T> samples_between(const std::vector<T>& values, std::size_t first, std::size_t last) {
    if (values.empty()) return {};
    return {values.begin() + static_cast<long>(first),
            values.begin() + static_cast<long>(std::min(last, values.size()))};
}

}  // namespace

recordings::TrackPath stretch(const recordings::TrackPath& path, double from_s, double to_s) {
    const auto count = static_cast<std::size_t>(std::lround((to_s - from_s) / path.step_s)) + 1;
    std::vector<double> times, speeds;
    for (std::size_t i = 0; i < count; ++i) {
        times.push_back(path.step_s * static_cast<double>(i));
        speeds.push_back(path.speed_at(from_s + times.back()));
    }
    return recordings::track_path(times, speeds, path.step_s, to_s - from_s);
}

recordings::Recording cut(const recordings::Recording& recording, double from_s, double to_s) {
    const recordings::TimeSeries& series = recording.series;
    const auto first = static_cast<std::size_t>(std::lround(from_s * series.sampling_rate_hz)),
               last = static_cast<std::size_t>(std::lround(to_s * series.sampling_rate_hz));
    recordings::Recording piece;
    piece.description = recording.description;
    piece.file = recording.file;
    piece.series.sampling_rate_hz = series.sampling_rate_hz;
    piece.series.start_s = series.start_s + from_s;
    for (const recordings::Channel& channel : series.channels)
        piece.series.channels.push_back({channel.description, samples_between(channel.samples, first, last)});
    piece.series.time_s = samples_between(series.time_s, first, last);
    piece.series.speed_m_per_s = samples_between(series.speed_m_per_s, first, last);
    piece.series.mileage_m = samples_between(series.mileage_m, first, last);
    return piece;
}

}  // namespace railpem::diagnosis

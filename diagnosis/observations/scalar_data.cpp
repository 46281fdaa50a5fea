#include "diagnosis/observations/scalar_data.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace railpem::diagnosis {

long third_octave_of(double frequency_hz) {
    return std::lround(10.0 * std::log10(frequency_hz));
}

std::vector<double> third_octave_means(const std::vector<ScalarValue>& values, const std::vector<double>& levels) {
    std::map<std::pair<std::size_t, long>, std::pair<double, double>> sums;
    const auto band = [](const ScalarValue& value) {
        return std::pair(value.channel, third_octave_of(value.frequency_hz));
    };
    for (std::size_t i = 0; i < values.size(); ++i) {
        auto& [sum, count] = sums[band(values[i])];
        sum += levels[i];
        count += 1.0;
    }
    std::vector<double> means;
    for (const ScalarValue& value : values) means.push_back(sums[band(value)].first / sums[band(value)].second);
    return means;
}

}  // namespace railpem::diagnosis

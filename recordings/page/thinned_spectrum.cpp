#include "recordings/page/thinned_spectrum.hpp"

#include <cassert>
#include <cmath>
#include <numeric>

namespace railpem::recordings {

double rounded(double value) {
    if (value == 0.0 || !std::isfinite(value)) return value;
    const double scale = std::pow(10.0, 4.0 - std::floor(std::log10(std::abs(value))));
    return std::isfinite(scale) ? std::round(value * scale) / scale : value;
}

std::vector<BinGroup> bin_groups(const std::vector<double>& frequency_hz) {
    std::vector<BinGroup> groups;
    std::size_t k = 0;
    while (k < frequency_hz.size() && frequency_hz[k] <= 0.0) ++k;
    while (k < frequency_hz.size()) {
        std::size_t end = k + 1;
        while (end < frequency_hz.size() && frequency_hz[end] < 1.01 * frequency_hz[k]) ++end;
        groups.push_back({k, end});
        k = end;
    }
    return groups;
}

std::vector<double> group_means(const std::vector<BinGroup>& groups, const std::vector<double>& values) {
    assert(groups.empty() || groups.back().end <= values.size());
    std::vector<double> means;
    means.reserve(groups.size());
    for (const auto [begin, end] : groups) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto last = values.begin() + static_cast<std::ptrdiff_t>(end);
        means.push_back(rounded(std::accumulate(first, last, 0.0) / static_cast<double>(end - begin)));
    }
    return means;
}

}  // namespace railpem::recordings

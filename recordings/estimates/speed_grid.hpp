#pragma once
// Speeds in equal relative steps, and the most probable way through them along a record.

#include <cmath>
#include <cstddef>
#include <vector>

namespace railpem::recordings {

/// Candidates of a first look for a speed, m/s.
struct SpeedGrid {
    double least = 0.0, ratio = 1.0;
    std::size_t count = 0;
    double at(std::size_t i) const { return least * std::pow(ratio, static_cast<double>(i)); }
};

/// The speeds from `least` to `most` in steps of `step`, relative.
inline SpeedGrid speed_grid(double least, double most, double step) {
    return {least, 1.0 + step, static_cast<std::size_t>(std::log(most / least) / step) + 1};
}

/// The path of highest total score, of [window][speed], whose neighbours differ by `most` steps of the grid at most
/// (Viterbi 1967).
std::vector<std::size_t> best_path(const std::vector<std::vector<double>>& score, std::size_t most);

}  // namespace railpem::recordings

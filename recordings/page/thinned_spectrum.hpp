#pragma once

#include <cstddef>
#include <vector>

namespace railpem::recordings {

/// A value with five significant digits: more is not seen in a picture.
double rounded(double value);

/// Neighbouring bins, end not included.
struct BinGroup {
    std::size_t begin = 0, end = 0;
};

/// Groups of bins for a curve on a logarithmic frequency axis: bins as they are at low frequency, 1 % wide groups
/// above, about 700 in all. Bins at zero frequency are in none.
std::vector<BinGroup> bin_groups(const std::vector<double>& frequency_hz);

/// Mean of each group, rounded(). A group with a NaN gives NaN.
std::vector<double> group_means(const std::vector<BinGroup>& groups, const std::vector<double>& values);

}  // namespace railpem::recordings

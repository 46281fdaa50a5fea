#pragma once

#include <vector>

#include "recordings/checks/evidence.hpp"

namespace railpem::recordings::checks {

/// Stretches of two seconds and more in which the axle boxes (or all channels, where there are none) are quiet.
/// `detrended`: per channel.
std::vector<Stretch> stops_of(const TimeSeries& series, const std::vector<std::vector<double>>& detrended);

}  // namespace railpem::recordings::checks

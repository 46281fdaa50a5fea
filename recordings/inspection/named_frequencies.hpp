#pragma once

#include <vector>

#include "recordings/inspection/inspection_report.hpp"

namespace railpem::recordings {

/// Frequencies to mark in a picture at this speed: sleeper passing (3 orders), wheel orders (5), mains. Without a
/// sleeper spacing 0.6 m is assumed and said in the name; without a radius no wheel order is given.
std::vector<NamedFrequency> named_frequencies(double speed_m_per_s, double highest_hz,
                                              const InspectionContext& context);

}  // namespace railpem::recordings

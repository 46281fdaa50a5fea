#pragma once
// Intervals are of 90 %.

namespace railpem::diagnosis {

inline constexpr double kNinety = 1.6449;  ///< 90 % of a Gaussian lie within so many deviations

}  // namespace railpem::diagnosis

#pragma once

#include <cstdint>

namespace railpem::simulate {

/// A smooth stationary Gaussian process of mean 0 and variance 1 at a place or time. Its correlation over a distance d
/// is exp(−π/4·(d/length)²), whose integral from 0 on is `length`; its derivative has the rms √(π/2)/length.
///
/// The sum of normal values on a grid of a quarter of the length, each drawn by its number alone and weighed by a bell:
/// the same seed is therefore the same curve, whatever stretch of it is looked at and in whatever order. What the grid
/// adds to the variance is below 1e-20. `length` > 0.
double smooth_noise_at(std::uint64_t seed, double place, double length);

}  // namespace railpem::simulate

#pragma once

#include <cstdint>
#include <utility>

namespace railpem::simulate {

/// Counter-based random numbers: the value depends on seed and counter only, so draws can be made in any order and the
/// same seed gives identical bits on every machine. SplitMix64's finaliser over a mixed counter (Steele, Lea & Flood
/// 2014, OOPSLA).
std::uint64_t bits_at(std::uint64_t seed, std::uint64_t counter);

/// Uniform in (0, 1).
double uniform_at(std::uint64_t seed, std::uint64_t counter);

/// Two independent standard normal values (Box & Muller 1958).
std::pair<double, double> normal_pair_at(std::uint64_t seed, std::uint64_t counter);

/// A seed of its own for each purpose of a record, so that no two streams coincide.
std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t purpose);

}  // namespace railpem::simulate

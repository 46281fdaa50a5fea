#include "simulate/numerics/random_numbers.hpp"

#include <cmath>
#include <numbers>

namespace railpem::simulate {

namespace {

std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

constexpr std::uint64_t golden_gamma = 0x9e3779b97f4a7c15ULL;

}  // namespace

std::uint64_t bits_at(std::uint64_t seed, std::uint64_t counter) {
    return mixed(mixed(seed + golden_gamma) + golden_gamma * (counter + 1));
}

double uniform_at(std::uint64_t seed, std::uint64_t counter) {
    return (static_cast<double>(bits_at(seed, counter) >> 11) + 0.5) * 0x1.0p-53;
}

std::pair<double, double> normal_pair_at(std::uint64_t seed, std::uint64_t counter) {
    const double radius = std::sqrt(-2.0 * std::log(uniform_at(seed, 2 * counter)));
    const double angle = 2.0 * std::numbers::pi * uniform_at(seed, 2 * counter + 1);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t purpose) {
    return bits_at(seed ^ 0xa0761d6478bd642fULL, purpose);
}

}  // namespace railpem::simulate

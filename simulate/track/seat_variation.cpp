#include "simulate/track/seat_variation.hpp"

#include <cmath>
#include <numbers>

#include "simulate/numerics/random_numbers.hpp"
#include "simulate/numerics/smooth_noise.hpp"

namespace railpem::simulate {

namespace {

// Purposes of derived seeds.
constexpr std::uint64_t for_pads = 311;
constexpr std::uint64_t for_support = 312;

/// A factor of mean 1: springs side by side then carry on average what equal ones would.
double log_normal(double deviation, double normal) {
    return std::exp(deviation * normal - 0.5 * deviation * deviation);
}

}  // namespace

double SeatScatter::pad_factor(std::int64_t seat) const {
    if (pad <= 0.0) return 1.0;
    return log_normal(pad, normal_pair_at(derived_seed(seed, for_pads), static_cast<std::uint64_t>(seat)).first);
}

double SeatScatter::dashpot_factor(std::int64_t seat) const {
    if (pad_damping <= 0.0) return 1.0;
    return log_normal(pad_damping,
                      normal_pair_at(derived_seed(seed, for_pads), static_cast<std::uint64_t>(seat)).second);
}

double SeatScatter::support_factor(std::int64_t seat) const {
    if (support <= 0.0) return 1.0;
    return log_normal(support,
                      smooth_noise_at(derived_seed(seed, for_support), static_cast<double>(seat), support_seats));
}

double SeatScatter::seat_factor(std::int64_t seat) const {
    return 1.0 / ((1.0 - ground_share) / pad_factor(seat) + ground_share / support_factor(seat));
}

bool SeatVariation::has_failed(std::int64_t seat) const {
    if (failed_every > 0 && (seat - failed_origin) % failed_every == 0) return true;
    return failed_fraction > 0.0 && uniform_at(failed_seed, static_cast<std::uint64_t>(seat)) < failed_fraction;
}

double SeatVariation::ground_scale(std::int64_t seat) const {
    if (ground_variation == 0.0) return 1.0;
    const double frequency =
        1.0 + ground_variation * std::sin(2.0 * std::numbers::pi * static_cast<double>(seat) / ground_period_seats);
    return frequency * frequency;
}

}  // namespace railpem::simulate

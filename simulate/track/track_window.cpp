#include "simulate/track/track_window.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate/numerics/random_numbers.hpp"

namespace railpem::simulate {

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

Stencil stencil_at(const TrackWindow& track, double position_m) {
    const double place = position_m - static_cast<double>(track.first_seat) * track.spacing_m;
    const auto last = static_cast<double>(track.nodes() - 2);
    const double element = std::clamp(std::floor(place / track.element_m), 0.0, last);
    return {static_cast<std::size_t>(element),
            displacement_shape(track.section, track.element_m, place - element * track.element_m)};
}

}  // namespace railpem::simulate

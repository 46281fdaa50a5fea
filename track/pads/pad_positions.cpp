#include "track/pads/pad_positions.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "track/pads/pad_scale.hpp"
#include "track/pads/seat_law.hpp"

namespace railpem::track {

namespace {

/// Distance over which a static disturbance of the rail decays to 1e-10, on the smeared foundation of unloaded seats.
double reach_m(const TrackParameters& track) {
    const SeatState unloaded = unloaded_seat(seat_law(track), rest_load_n(track));
    const double foundation = mean_pad_scale(track) * unloaded.tangent_n_per_m / track.spacing_m;
    const double beta = std::pow(foundation / (4.0 * static_bending_stiffness(track)), 0.25);
    return std::log(1e10) / beta;  // shear shortens it, so the Euler value serves both beams
}

double seat_0_m(const TrackParameters& track, const std::vector<double>& wheels_m) {
    assert(!wheels_m.empty());
    return wheels_m.front() - track.wheel_offset_m;
}

}  // namespace

std::vector<double> pad_positions(const TrackParameters& track, const std::vector<double>& wheels_m, int count) {
    assert(count >= 0);
    const double origin = seat_0_m(track, wheels_m);
    const double rounding = 1e-9;  // in bays: rounding of positions must not move a seat
    std::int64_t first = 0;
    if (count > 0) {
        first = static_cast<std::int64_t>(std::floor(-origin / track.spacing_m - 0.5 * (count - 1) + 0.5 + rounding));
    } else {
        const auto [rear, front] = std::minmax_element(wheels_m.begin(), wheels_m.end());
        const double reach = reach_m(track);
        first = static_cast<std::int64_t>(std::floor((*rear - reach - origin) / track.spacing_m));
        const auto last = static_cast<std::int64_t>(std::ceil((*front + reach - origin) / track.spacing_m));
        count = static_cast<int>(last - first + 1);
    }
    std::vector<double> pads_m(static_cast<std::size_t>(count));
    for (std::size_t j = 0; j < pads_m.size(); ++j)
        pads_m[j] = origin + static_cast<double>(first + static_cast<std::int64_t>(j)) * track.spacing_m;
    return pads_m;
}

std::int64_t seat_index(const TrackParameters& track, const std::vector<double>& wheels_m, double pad_m) {
    return std::llround((pad_m - seat_0_m(track, wheels_m)) / track.spacing_m);
}

}  // namespace railpem::track

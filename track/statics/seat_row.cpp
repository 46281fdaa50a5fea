#include "track/statics/seat_row.hpp"

#include <algorithm>
#include <cmath>

#include "track/pads/pad_scale.hpp"

namespace railpem::track {

std::vector<Seat> seat_row(const TrackParameters& track, const std::vector<double>& points_m,
                           const StaticEquilibrium& equilibrium) {
    const double rearmost = *std::min_element(points_m.begin(), points_m.end());
    const double foremost = *std::max_element(points_m.begin(), points_m.end());
    const std::size_t count = equilibrium.position_m.size();
    const double uniform = equilibrium.unloaded_dynamic_stiffness_n_per_m;
    const double origin = points_m.front() - track.wheel_offset_m;  // seat 0 of the numbering of failed fasteners
    std::vector<Seat> seats;
    seats.reserve(count);
    const auto add_seat = [&](double position, double stiffness) {
        const auto seat = static_cast<std::int64_t>(std::llround((position - origin) / track.spacing_m));
        seats.push_back({position, stiffness, pad_scale(track, seat)});
    };
    const double before = equilibrium.position_m.front() - rearmost;
    const double after = foremost - equilibrium.position_m.back();
    for (int n = before < 0.0 ? 0 : static_cast<int>(std::ceil(before / track.spacing_m)) + 1; n > 0; --n)
        add_seat(equilibrium.position_m.front() - n * track.spacing_m, uniform);
    for (std::size_t j = 0; j < count; ++j)
        add_seat(equilibrium.position_m[j], equilibrium.dynamic_stiffness_n_per_m[j]);
    for (int n = 1; after > 0.0 && n <= static_cast<int>(std::ceil(after / track.spacing_m)) + 1; ++n)
        add_seat(equilibrium.position_m.back() + n * track.spacing_m, uniform);
    return seats;
}

}  // namespace railpem::track

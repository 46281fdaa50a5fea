#include "track/statics/moving_equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "track/pads/pad_curve.hpp"
#include "track/pads/pad_law.hpp"
#include "track/pads/seat_law.hpp"
#include "track/statics/rolling_pads.hpp"

namespace railpem::track {

double PassingChange::at(double position_m) const {
    const double place = (position_m - first_m) / step_m;
    const auto i = static_cast<std::ptrdiff_t>(std::floor(place));
    if (i < 1 || i + 2 >= static_cast<std::ptrdiff_t>(change_n_per_m.size())) return 0.0;
    const double t = place - static_cast<double>(i), *y = &change_n_per_m[static_cast<std::size_t>(i)];
    return -t * (t - 1.0) * (t - 2.0) / 6.0 * y[-1] + (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0 * y[0] -
           (t + 1.0) * t * (t - 2.0) / 2.0 * y[1] + (t + 1.0) * t * (t - 1.0) / 6.0 * y[2];
}

PassingChange passing_change(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n,
                             const PadHistory& rolling) {
    PassingChange change;
    const PadHistory standing = pad_history(track, wheels_m, wheel_load_n, 0.0, true, {}, &rolling);
    const TrackParameters passing = passing_track(track, wheel_load_n);
    const PadCurve curve = pad_curve(passing.pads);
    const double rest = unloaded_seat(seat_law(passing), rest_load_n(passing)).compression_m;
    // A pad ahead of the wheels is one that they have not reached.
    const std::size_t points = rolling.compression_m.size();
    change.step_m = rolling.step_m;
    change.first_m = -(rolling.first_m + static_cast<double>(points - 1) * rolling.step_m);
    for (std::size_t i = points; i-- > 0;)
        change.change_n_per_m.push_back(pad_stiffness(curve, rest + rolling.compression_m[i]) -
                                        pad_stiffness(curve, rest + standing.compression_m[i]));
    return change;
}

StaticEquilibrium moving_equilibrium(const TrackParameters& track, const std::vector<double>& wheels_m,
                                     double wheel_load_n, const std::vector<double>& pads_m,
                                     const PassingChange& change, const StaticEquilibrium* start) {
    const TrackParameters passing = passing_track(track, wheel_load_n);
    const PadCurve statics = pad_curve(track.pads), elastic = pad_curve(passing.pads);
    StaticEquilibrium result = static_equilibrium(passing, wheels_m, wheel_load_n, pads_m, start);
    for (std::size_t j = 0; j < pads_m.size(); ++j) {
        result.static_stiffness_n_per_m[j] = pad_stiffness(
            statics, pad_compression(statics, std::max(0.0, pad_force(elastic, result.compression_m[j]))));
        result.dynamic_stiffness_n_per_m[j] =
            initial_dynamic_stiffness(track.pads, result.static_stiffness_n_per_m[j]) + change.at(pads_m[j]);
    }
    result.unloaded_static_stiffness_n_per_m =
        pad_stiffness(statics, pad_compression(statics, pad_force(elastic, result.unloaded_compression_m)));
    result.unloaded_dynamic_stiffness_n_per_m =
        initial_dynamic_stiffness(track.pads, result.unloaded_static_stiffness_n_per_m);
    return result;
}

}  // namespace railpem::track

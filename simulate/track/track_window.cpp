#include "simulate/track/track_window.hpp"

#include <algorithm>
#include <cmath>

namespace railpem::simulate {

Stencil stencil_at(const TrackWindow& track, double position_m) {
    const double place = position_m - static_cast<double>(track.first_seat) * track.spacing_m;
    const auto last = static_cast<double>(track.nodes() - 2);
    const double element = std::clamp(std::floor(place / track.element_m), 0.0, last);
    return {static_cast<std::size_t>(element),
            displacement_shape(track.section, track.element_m, place - element * track.element_m)};
}

}  // namespace railpem::simulate

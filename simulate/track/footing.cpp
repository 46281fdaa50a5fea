#include "simulate/track/footing.hpp"

#include <cmath>

namespace railpem::simulate {

namespace {

/// What an element gives under a load spread over a length a next to its node. With c(x) = (x − x²/l')/κGA under a
/// point, the mean of (min(x, x') − x·x'/l')/κGA.
double under_spread_load(const TrackWindow& track, double length_m) {
    return 0.25 * compliance_between_nodes(track.section, track.element_m, length_m) +
           track.section.shear_flexibility_per_n * length_m / 12.0;
}

/// The load of a rolling wheel passes a node: the parts of the way before and behind it bear it as their midpoints do
/// (a kink is straight on either side). Farther off a load spread over the whole way gives way/6κGA less than one at a
/// point, which is no more than a shift of the rail: it is added here instead of taken off there.
Footing across_node(const TrackWindow& track, double place_m, double node_m, double way_m) {
    const double before = 0.5 * way_m - (place_m - node_m), behind = way_m - before, share = before / way_m;
    const double local = share * share * under_spread_load(track, before) +
                         (1.0 - share) * (1.0 - share) * under_spread_load(track, behind);
    return {.parts = {{{stencil_at(track, node_m - 0.5 * before), share},
                       {stencil_at(track, node_m + 0.5 * behind), 1.0 - share}}},
            .count = 2,
            .local_compliance_m_per_n = local + track.section.shear_flexibility_per_n * way_m / 6.0};
}

}  // namespace

Footing footing(const TrackWindow& track, const StageLoad& load, std::size_t stage) {
    const double place = load.position_m[stage];
    if (track.section.shear_flexibility_per_n > 0.0) {
        const double way = (load.position_m[1] - load.position_m[0]) / (1.0 - RadauStep::first_stage);
        const double node = std::round(place / track.element_m) * track.element_m;
        if (2.0 * std::abs(place - node) < way) return across_node(track, place, node, way);
    }
    const double element = place / track.element_m;
    return {.parts = {{{stencil_at(track, place), 1.0}, {}}},
            .count = 1,
            .local_compliance_m_per_n = compliance_between_nodes(track.section, track.element_m,
                                                                 (element - std::floor(element)) * track.element_m)};
}

}  // namespace railpem::simulate

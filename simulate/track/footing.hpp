#pragma once
// What a wheel touches of the rail within a step.

#include <array>
#include <cstddef>

#include "simulate/track/track_window.hpp"

namespace railpem::simulate {

/// The elements that bear a load, by shares, and how much they give under it beyond their shape functions, m/N.
/// A rail that shears has a kink over every seat. Wheels that are looked at once a step, h, would make of its harmonics
/// near 1/h lines near zero (of 33 m/s at 60 and 160 Hz), which nothing but the step makes. A load that passes a node
/// of such a rail is therefore spread over the way of one step, whose mean has no such harmonics, and so is the place
/// where the rail is read. Elsewhere, and on a rail that does not shear, it is a point.
struct Footing {
    struct Part {
        Stencil at;
        double share;
    };
    std::array<Part, 2> parts;
    std::size_t count;
    double local_compliance_m_per_n;
};

Footing footing(const TrackWindow& track, const StageLoad& load, std::size_t stage);

}  // namespace railpem::simulate

#include "spectra/rail_joint_lines.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace railpem::spectra {

namespace {

double sinc(double x) {
    const double angle = std::numbers::pi * x;
    return angle == 0.0 ? 1.0 : std::sin(angle) / angle;
}

}  // namespace

double joint_line_amplitude_m(const RailJoints& joints, int order) {
    assert(order >= 1);
    const double ratio = order * joints.length_m / joints.spacing_m;
    // sin(πr) = sin(π(1 − r)): the second form has no 0/0 at r = 1, the first none at r = 0.
    const double shape =
        ratio < 0.5 ? sinc(ratio) / (1.0 - ratio * ratio) : sinc(1.0 - ratio) / (ratio * (1.0 + ratio));
    return -joints.depth_m * joints.length_m / joints.spacing_m * shape;
}

}  // namespace railpem::spectra

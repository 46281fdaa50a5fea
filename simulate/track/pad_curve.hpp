#pragma once

#include <vector>

#include "simulate/only_here_parameters.hpp"
#include "track/track_parameters.hpp"

namespace railpem::simulate {

/// Elastic force of one pad against its compression x from the unloaded state (clips and rail weight only), tabulated.
/// Positive in compression; beyond the table the tangent goes on.
struct PadCurve {
    double first_m = 0.0;
    double step_m = 1.0;
    std::vector<double> force_n;  ///< at first + i·step
    std::vector<double> tangent_n_per_m;

    double force(double x) const;  ///< cubic between the points, so force and tangent are continuous
    double tangent(double x) const;
    double compression(double force) const;  ///< the inverse
};

/// Static curve F(S) about the unloaded compression S0, F(S0) = clip preload + weight of one bay of rail. Linear with
/// the secant stiffness where the case gives no curve or takes no account of it (preload_strength = 0). `play`: stretch
/// over which the pad carries a tenth of its stiffness only; none when its gap is 0.
PadCurve static_curve(const track::TrackParameters& track, const PadDeadBand& play);

/// Curve for vibration and passing wheels. Its tangent is ratio·[(1 − s)·K_secant + s·K(S)] at the compression S that
/// carries the same load statically: a pad is as stiff as its preload makes it, however fast the preload came.
PadCurve dynamic_curve(const track::TrackParameters& track, const PadDeadBand& play);

/// True when the pad's tangent depends on its load.
bool is_nonlinear(const track::PadParameters& pads, const PadDeadBand& play);

}  // namespace railpem::simulate

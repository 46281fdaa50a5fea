#pragma once
// The pads under a rolling vehicle: what preload makes of their stiffness when the load comes and goes with the wheels.

#include <vector>

#include "track/static_equilibrium.hpp"

namespace railpem::track {

/// How far the memory of the pads and the rail's inertia bend the travelling stiffness away from that of a standing load: K0 in N/m over the
/// position in the frame of the wheels. All zero where nothing depends on speed.
struct PassingChange {
    double first_m = 0.0;
    double step_m = 1.0;
    std::vector<double> change_n_per_m;

    /// Cubic between the points, 0 beyond them.
    double at(double position_m) const;
};

/// A wheel that rolls by loads a pad for less than a tenth of a second. The pad answers with its dynamic stiffness, the rail with its own
/// bending stiffness (StaticParameters::second_moment_of_area_m4 is for standing loads): elastic force E(x) with the tangent
/// K0(F) = ratio·[(1 − s)·K_secant + s·K(S)], S the compression that carries F statically, and the pad force g ∗ E + c·ẋ, g the shape of the pad
/// (quasi-linear viscoelasticity, Fung 1993, section 7.6). In the frame of the wheels, per metre of rail with the supports smeared:
///   (Bk⁴ − μ(kv)²)·u + [g(−kv)·E(x) − ikvc·x]/spacing = loads,   u = x + what the support below gives
/// The difference to the same track with g = 1 and v = 0. Pads settle
/// in the end: from 0.5 Hz down g goes on as one relaxation. To 1e-10 of the largest force.
PassingChange passing_change(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n, double speed_m_per_s);

/// The pads under the wheels of a vehicle that rolls: equilibrium of the discrete track with E as the pads' curve, `change` added to its dynamic
/// stiffness. `track.pads.preload_strength` > 0. Everything else as static_equilibrium().
StaticEquilibrium moving_equilibrium(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n,
                                     const std::vector<double>& pads_m, const PassingChange& change, const StaticEquilibrium* start = nullptr);

}  // namespace railpem::track

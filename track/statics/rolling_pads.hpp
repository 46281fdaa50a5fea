#pragma once
// What every pad goes through while a vehicle rolls past, and how far the rail sinks under its wheels between the
// seats.

#include <complex>
#include <vector>

#include "track/track_modifiers.hpp"
#include "track/track_parameters.hpp"

namespace railpem::track {

/// `track` as passing wheels meet it: the pads' only curve is the elastic force E(x) whose tangent is the dynamic
/// stiffness at rest frequency, K0(F) = ratio·[(1 − s)·K_secant + s·K(S)], S the compression that carries F statically;
/// the rail has its own bending stiffness (StaticParameters::second_moment_of_area_m4 is for standing loads).
TrackParameters passing_track(const TrackParameters& track, double wheel_load_n);

/// One pad while wheels with constant loads roll past at v; s = vt is how far they have come, wheel i stands over the
/// pad at s = −a_i. All pads have the same history, each delayed by one spacing/v more than the one before.
struct PadHistory {
    double first_m = 0.0, step_m = 1.0;  ///< of s
    /// elastic, beyond that at rest; empty where it is nowhere needed (linear pads)
    std::vector<double> compression_m;
    /// ∫ f e^{−iκs} ds of the pad's force beyond that at rest, κ = n·2π/(size·step), n = 0 to size/2
    std::vector<std::complex<double>> force_n_m;
    double wavenumber_step_per_m = 0.0;
};

/// The pad answers with its dynamic stiffness: the elastic force E(x) and the pad force f = g ∗ (E(x) − E_rest) + c·ẋ,
/// g the shape of the pad (quasi-linear viscoelasticity, Fung 1993, section 7.6), pads settling in the end: from 0.5 Hz
/// down g goes on as one relaxation. Nothing is smeared: a beam on equal supports at every spacing L that all go
/// through the same, one after the other, obeys a single equation for one of them (Hoang, Duhamel & Foret 2014, Int. J.
/// Mech. Sci. 83; here with pads whose stiffness changes with their load). With D(k, ω) the rail's dynamic stiffness
/// for e^{i(ωt + kx)} and ω = κv,
///   x + R·f = Σ_i P·e^{iκa_i}/D(−κ, ω) − f·(1/L)·Σ_m 1/D(2πm/L − κ, ω)
/// R the receptance below the pad. The nonlinear part goes to and fro between s and κ until it stands to 1e-10.
/// `standing`: v = 0, g = 1, without loss and inertia. Pads do not lift: below zero force the tangent of E goes on.
/// Failed fasteners are not seen. Throws parameters::ParameterError where the iteration finds no end. `swelling`:
/// complex peaks F_i of loads Re(F_i·e^{2πi·vt/L}) beside the constant ones, which swell alike over every pad, so that
/// all still go through the same; the load's transform is then ½F·e^{−i(2π/L − κ)a}/D(2π/L − κ, ω) and the like of its
/// conjugate. `near`: a history of the same grid (wheels and spacing), from whose compressions the iteration starts.
PadHistory pad_history(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n,
                       double speed_m_per_s, bool standing = false,
                       const std::vector<std::complex<double>>& swelling_n = {}, const PadHistory* near = nullptr,
                       const TrackModifiers& modifiers = {});

/// Deflection of the rail under each wheel, positive downwards: the coefficients of e^{i·2πm·vt/L}, m = 1 to `orders`,
/// [(m − 1)·wheels + wheel], t = 0 where x = 0 stands over a seat. `history` of the same track, wheels and speed.
///   c_m = −(1/L)·∫ e^{ik_m·a} f̃(κ)/D(k_m, κv) dκ/2π,  k_m = 2πm/L − κ
/// `standing` as in pad_history(): under loads that stand at vt, one place after the other.
std::vector<std::complex<double>> rolling_deflection(const TrackParameters& track, const std::vector<double>& wheels_m,
                                                     double speed_m_per_s, const PadHistory& history, int orders,
                                                     bool standing = false, const TrackModifiers& modifiers = {});

/// How the rail over the pad under one wheel that crawls answers to more load: w(P0 + F) = w(P0) + C·F + ½κF².
struct LoadedDeflection {
    double compliance_m_per_n = 0.0;  ///< C
    double curvature_m_per_n2 = 0.0;  ///< κ, negative where load stiffens
};

/// `track.pads.preload_strength` > 0.
LoadedDeflection loaded_deflection(const TrackParameters& track, double wheel_load_n);

}  // namespace railpem::track

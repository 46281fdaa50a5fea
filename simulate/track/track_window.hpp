#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulate/numerics/block_tridiagonal.hpp"
#include "simulate/track/beam_element.hpp"
#include "simulate/track/seat_row.hpp"
#include "simulate/track/seat_variation.hpp"

namespace railpem::simulate {

/// How much rail travels with the vehicle, and how finely it is divided.
struct WindowOptions {
    /// 0.15 m on sleepers every 0.6 m. Two would do for the waves (phase velocity within 1e-3 up to 500 Hz for rails of
    /// 50 kg/m and more), but have a line of their own where the supports have their second, which they make 8 %
    /// smaller (Moving.SecondSleeperPassingLine).
    int elements_per_bay = 4;
    double margin_m = 7.2;                ///< undisturbed rail beyond the outermost wheels
    double absorber_m = 14.4;             ///< then rail with a dashpot that grows with the square of the distance
    double absorber_rate_per_s = 3000.0;  ///< at its end, per unit of rail mass
};

/// Masses hung along the rail, lumped at its nodes.
struct DamperLaw {
    double mass_kg, stiffness_n_per_m, damping_n_s_per_m;  ///< per node
    Complex coupling, receptance;                          ///< k + c·s and 1/(m·s² + k + c·s)
};

/// A stretch of track that travels with the vehicle, bay by bay: what enters ahead is at rest, what leaves behind is
/// forgotten, and absorbing ends keep both from being felt. Rail displacements are relative to the unloaded track
/// (moving) or to the static equilibrium under the standing vehicle.
struct TrackWindow {
    Section section;
    double element_m = 0.0;
    double spacing_m = 0.0;
    int elements_per_bay = 2;
    int bays = 0;
    std::int64_t first_seat = 0;  ///< number of the seat at node 0
    int wheel_1_bay = 0;          ///< bay of the window in which wheel 1 stays
    double rail_loss_s = 0.0;     ///< η/ω_ref: stiffness-proportional damping

    Eigen::Matrix4d mass, stiffness;  ///< of one element
    std::vector<double> absorber_n_s_per_m;
    std::vector<DamperLaw> dampers;
    SeatLaw law;
    SeatStep seat_numbers;
    SeatVariation variation;

    std::vector<double> w, theta, velocity_w, velocity_theta;  ///< nodal state
    std::vector<std::vector<Motion>> damper_motion;            ///< [damper][node]
    std::vector<Seat> seats;                                   ///< one per bay boundary

    BlockTridiagonal rail;  ///< without the seats
    BlockFactors factors;
    std::vector<Pair> history, solution;
    std::vector<std::vector<Complex>> damper_history;  ///< H of each damper and node

    std::size_t nodes() const { return w.size(); }
};

/// A point load over the two stages: place (metres from seat number 0) and force, downwards on the rail.
struct StageLoad {
    std::array<double, 2> position_m;
    std::array<double, 2> force_n;
};

/// Interpolation at one place: node before it and the shape functions.
struct Stencil {
    std::size_t node;
    Eigen::Vector4d shape;
};
Stencil stencil_at(const TrackWindow& track, double position_m);

}  // namespace railpem::simulate

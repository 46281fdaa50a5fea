#pragma once

#include <vector>

#include "simulate/numerics/radau_step.hpp"
#include "simulate/numerics/relaxation_chain.hpp"
#include "simulate/track/pad_curve.hpp"

namespace railpem::simulate {

/// A mass on spring and dashpot under every seat that moves with the pad's foot: sleeper, sleeper mode or subgrade.
/// Driven by the pad force alone; the foot moves by the sum of all of them.
struct Oscillator {
    double mass_kg = 0.0;
    double damping_n_s_per_m = 0.0;
    double stiffness_n_per_m = 0.0;
};

/// What all seats have in common.
struct SeatLaw {
    RelaxationChain chain;
    double dashpot_n_s_per_m = 0.0;
    double reference_stiffness_n_per_m = 0.0;  ///< tangent of the unloaded pad at g = 1: the stiffness in the matrix
    bool nonlinear = false;
    PadCurve curve;  ///< nonlinear only
    std::vector<Oscillator> oscillators;
    bool supported = false;  ///< the first oscillator is the sleeper on its ballast
};

/// State of one oscillator, upwards positive.
struct Motion {
    double displacement_m = 0.0;
    double velocity_m_per_s = 0.0;
};

/// One seat. Compression x = foot − rail (both upwards positive); force F on the rail upwards, on the foot downwards:
///   F = share·( g∗E(x) + scale·c·ẋ ), E the elastic curve about the compression `origin_m`, g the chain.
struct Seat {
    double share = 1.0;          ///< of stiffness and damping, relative to the law (failed fasteners, scatter)
    double dashpot_scale = 1.0;  ///< of the dashpot beside that
    double origin_m = 0.0;       ///< of the curve: 0 unloaded, in standing mode the static compression
    double reference_stiffness_n_per_m = 0.0;
    std::vector<double> oscillator_scale;  ///< stiffness of each oscillator relative to the law's (ground that varies)
    double compression_m = 0.0;            ///< at the start of the step
    std::vector<double> branch_force_n;
    std::vector<Motion> oscillators;

    // Transforms within the current step.
    Complex condensed_stiffness;  ///< seen by the rail node
    Complex constant_force;       ///< from the state at the start of the step
    Complex softening;            ///< of the pad by its moving foot
    Complex residual_gain;        ///< of the nonlinear residual on the force
    Complex residual;             ///< E(x) − K_ref·x over the stages
    Complex force;
    Complex compression;
    std::vector<Complex> oscillator_receptance;
    std::vector<Complex> oscillator_history;
};

/// Numbers of the law at the step's complex frequency.
struct SeatStep {
    Complex modulus;                     ///< g(s)
    std::vector<Complex> branch_weight;  ///< strength·sτ/(1 + sτ)
    std::vector<Complex> branch_old;     ///< share of the old branch force in the transform, sτ·1̂/(1 + sτ)
    std::vector<Complex> branch_new;     ///< share of the elastic force, 1/(1 + sτ)
};

SeatStep seat_step(const SeatLaw& law, const RadauStep& step);

/// A fresh seat at rest, unloaded.
Seat fresh_seat(const SeatLaw& law);

/// Stiffnesses of the seat at the step's frequency; to be called when share, origin or ground change.
void set_stiffness(Seat& seat, const SeatLaw& law, const SeatStep& numbers, const RadauStep& step);

/// History of the state at the start of a step; sets `constant_force`, keeps the last residual as the first guess.
void begin_step(Seat& seat, const SeatLaw& law, const SeatStep& numbers, const RadauStep& step);

/// Force and motion for the rail's displacement at the seat. Returns how far the nonlinear residual moved, N.
double respond(Seat& seat, const SeatLaw& law, const RadauStep& step, Complex rail);

/// New state at the end of the step.
void finish_step(Seat& seat, const SeatLaw& law, const SeatStep& numbers, const RadauStep& step);

/// Force on the rail from the state before the solve (constant force and residual), for the right-hand side.
inline Complex applied_force(const Seat& seat) {
    return seat.constant_force + product(seat.residual_gain, seat.residual);
}

}  // namespace railpem::simulate

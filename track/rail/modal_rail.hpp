#pragma once
// The rail as a sum of bending modes: the method of the published vehicle-track models.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "track/track_modifiers.hpp"
#include "track/track_parameters.hpp"

namespace railpem::track {

/// A finite, simply supported Euler rail on discrete complex springs. It ends half a bay beyond the outermost pads, so
/// its length is (number of pads)·spacing. Mode n = 1 … N, normalised to unit mass of the bare rail m·L:
///   φ_n(x) = √(2/(mL))·sin(nπx/L),   ω_n = (nπ/L)²·√(EI/m)
/// with x from the rear end.
struct ModalRail {
    Eigen::VectorXd circular_frequency_rad_per_s;  ///< ω_n of the rail without pads and dampers
    Eigen::MatrixXd pad_shape;                     ///< φ_n at the pads, pads × modes, kg^(−1/2)
    Eigen::MatrixXd point_shape;                   ///< φ_n at the points (wheels), points × modes
    double loss_factor = 0.0;                      ///< of the rail's E
    double mass_kg_per_m = 0.0;
    std::vector<RailDamper> dampers;  ///< spread evenly over the rail: they load every mode alike
    lanes::FactorCurve mass_factor;   ///< TrackModifiers::rail
};

/// What a frequency line needs of the rail. Displacement and force in the same direction.
struct ModalReceptance {
    Eigen::MatrixXcd at_points;    ///< displacement at point i for a unit force at point j, points × points, m/N
    Eigen::MatrixXcd at_pads;      ///< displacement over pad i for a unit force at point j, pads × points, m/N
    Eigen::RowVectorXcd trackbed;  ///< sum of all pad forces, in compression, for a unit downward force at point j, N/N
};

/// Mode shapes at pads and points, computed once. `modes` ≥ 1; `points_m`: wheels, or wherever a force acts.
/// Range: frequencies well below ω_N/2π; the error of `modes` and of the length is in the README of this folder.
/// Throws parameters::ParameterError for a Timoshenko rail (its modes are not sines with one frequency each), for a
/// point off the rail, and for `modes` < 1.
ModalRail modal_rail(const TrackParameters& track, const std::vector<double>& pads_m,
                     const std::vector<double>& points_m, int modes, const TrackModifiers& modifiers = {});

/// Solves D·q = Φᵀ F with the dense, complex symmetric N × N matrix
///   D = diag(ω_n²(1 + iη) − ω²(1 + Σ m_d(ω)/m)·factor) + Σ_j K_j φ(x_j) φ(x_j)ᵀ,
/// m_d(ω) the dynamic mass of the dampers (see RailDamper). `seat_stiffness_n_per_m`: complex K_j from rail to ground,
/// one per pad, as from seat_stiffness(). f > 0, in Hz. Cost O(N³) per line: this is the reference method, not the fast
/// one.
ModalReceptance modal_receptance(const ModalRail& rail, double frequency_hz,
                                 const Eigen::VectorXcd& seat_stiffness_n_per_m);

}  // namespace railpem::track

#pragma once
// The exact, infinite, discretely supported rail: dynamic-stiffness elements between the supports that matter, the
// Bloch impedance of the uniform track beyond them. Nothing is truncated, and the cost grows linearly with the number
// of nodes.

#include <vector>

#include "lanes/complex_lanes.hpp"
#include "track/rail/bloch.hpp"
#include "track/statics/static_equilibrium.hpp"
#include "track/track_modifiers.hpp"
#include "track/track_parameters.hpp"

namespace railpem::track {

/// A node of the finite part, from the rear to the front.
struct RailNode {
    double position_m = 0.0;
    double pad_stiffness_n_per_m = 0.0;  ///< K0 at the reference frequency; meaningless without a support
    double pad_scale = 1.0;              ///< what is left of stiffness and damping (failed fasteners)
    bool supported = false;
    int point = -1;    ///< index of the point (wheel) that stands here, or −1
    int stretch = -1;  ///< index into ExactRail::lengths_m of the rail from here to the next node
};

/// Geometry and stiffness, prepared once for all frequencies.
struct ExactRail {
    RailParameters rail;
    std::vector<RailDamper> dampers;
    PadParameters pads;
    SupportParameters support;
    TrackModifiers modifiers;
    double spacing_m = 0.6;
    double uniform_pad_stiffness_n_per_m = 0.0;  ///< K0 of every pad beyond the finite part
    std::vector<RailNode> nodes;
    std::vector<double> lengths_m;  ///< distinct lengths of rail between nodes; [0] is a whole bay
    int points = 0;
};

/// The finite part holds the supports whose K0 differs from the uniform one by more than `tolerance` (relative), and
/// the stretch between the outermost points. `points_m`: where receptances are asked, in any order, anywhere in a bay.
ExactRail exact_rail(const TrackParameters& track, const std::vector<double>& points_m,
                     const StaticEquilibrium& equilibrium, const TrackModifiers& modifiers = {},
                     double tolerance = 1e-10);

/// The same with every support alike (track without a vehicle, at rest): K0 = `pad_stiffness_n_per_m`, a support at
/// position 0.
ExactRail uniform_rail(const TrackParameters& track, const std::vector<double>& points_m, double pad_stiffness_n_per_m,
                       const TrackModifiers& modifiers = {});

/// Receptances at the points for unit upward forces, m/N, and the sum of all pad forces they cause.
struct RailReceptance {
    std::vector<lanes::Complex> between;  ///< [i·points + j], symmetric
    /// [j]: Σ over all pads, finite part and both infinite ends, of K·w per unit force at j
    std::vector<lanes::Complex> trackbed;
    const lanes::Complex& at(int i, int j) const {
        return between[static_cast<std::size_t>(i) * trackbed.size() + static_cast<std::size_t>(j)];
    }
};

/// Memory that one thread needs for one rail; a few hundred bytes per node and lane group.
struct ExactRailWorkspace {
    explicit ExactRailWorkspace(const ExactRail& rail);
    std::vector<RailElement> elements;      ///< per distinct length
    std::vector<lanes::Complex> supports;   ///< per node
    std::vector<lanes::Matrix2> condensed;  ///< per node: (stiffness of everything behind, with the next stretch)⁻¹
    std::vector<lanes::Matrix2> back;       ///< per node: d_j = back·d_{j+1} when nothing acts at or behind j
    std::vector<lanes::Vector2> load;       ///< per node: condensed load of the pad-sum problem
    std::vector<int> met;                   ///< points met on the way back
    std::vector<lanes::Vector2> row;        ///< and their columns of the inverse, as far as the present node
    RailReceptance result;
};

/// Complex dynamic stiffness of one support seen by the rail: pad K0·scale in series with what lies below it.
/// Evaluates the frequency laws once per lane.
class SupportLaw {
  public:
    SupportLaw(const PadParameters& pads, const SupportParameters& support, lanes::Real omega,
               const TrackModifiers& modifiers = {});
    lanes::Complex stiffness(double pad_stiffness_n_per_m, double scale = 1.0) const;

    /// stiffness(K0, scale) − stiffness(K0 of `uniform_n_per_m`) as a fraction, so that what goes on with it needs no
    /// division of its own and small changes do not cancel: with pads P and P_u on R below, [(P − P_u)/(1 + P_u·R)] /
    /// (1 + P·R).
    class Change {
      public:
        lanes::Complex numerator(double pad_stiffness_n_per_m, double scale) const {
            return over_stiffness_ * (pad_stiffness_n_per_m * scale - uniform_) + over_scale_ * (scale - 1.0);
        }
        lanes::Complex denominator(double pad_stiffness_n_per_m, double scale) const {
            return under_stiffness_ * (pad_stiffness_n_per_m * scale) + under_scale_ * scale + 1.0;
        }

      private:
        friend class SupportLaw;
        lanes::Complex over_stiffness_, over_scale_, under_stiffness_, under_scale_;
        double uniform_ = 0.0;
    };
    Change change_from(double uniform_n_per_m) const;

  private:
    lanes::Complex shape_, dashpot_, below_;
    bool rigid_;
};

/// Solves one group of lines: condensation from the rear, selected inversion from the front (block-tridiagonal, 2×2
/// blocks). ω > 0 in rad/s. The reference returned lives in the workspace.
const RailReceptance& rail_receptance(const ExactRail& rail, lanes::Real omega, ExactRailWorkspace& workspace);

/// Half of the infinite uniform track at ω (its decay per bay, its impedance).
HalfTrack uniform_half_track(const ExactRail& rail, lanes::Real omega);

/// The same with what it is made of known: a bay of rail and a support at ω.
HalfTrack uniform_half_track(const ExactRail& rail, lanes::Real omega, const RailElement& bay,
                             const lanes::Complex& support);

}  // namespace railpem::track

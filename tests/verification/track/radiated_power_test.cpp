// Where the power goes that a force puts into the infinite track: into the supports and the rail, all the way to
// infinity, or, without any loss, away along it. The waves of the half tracks (bloch.hpp) are followed support by
// support, so that their impedance is checked against what their own displacements dissipate or carry.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "track/rail/exact_rail.hpp"

namespace railpem::track {
namespace {

using Complex = std::complex<double>;
using Pair = Eigen::Vector2cd;

Eigen::Matrix2cd block(const lanes::Matrix2& m) {
    Eigen::Matrix2cd result;
    result << m.a[0], m.b[0], m.c[0], m.d[0];
    return result;
}

/// ½ω·Im(dᴴKd): power that a structure of dynamic stiffness K takes up, moving by d.
double power(double omega, const Eigen::MatrixXcd& stiffness, const Eigen::VectorXcd& d) {
    return 0.5 * omega * (d.adjoint() * stiffness * d)(0, 0).imag();
}

/// The track at one frequency under a unit force over the support at 0.
struct Driven {
    double omega, supplied;
    Complex support;
    Eigen::Matrix2cd half, advance;  ///< of everything beyond a node, and from node to node
    Eigen::Matrix4cd bay;
    Pair first;  ///< (w, ψ) under the force; ψ = 0 by symmetry
};

Driven driven(const TrackParameters& track, double stiffness, double frequency) {
    const ExactRail rail = uniform_rail(track, {0.0}, stiffness);
    ExactRailWorkspace workspace(rail);
    const double omega = 2.0 * std::numbers::pi * frequency;
    const lanes::Real group = lanes::broadcast(omega);
    const HalfTrack ahead = uniform_half_track(rail, group);
    const RailElement bay = rail_element(beam_coefficients(track.rail, track.rail_dampers, group), track.spacing_m);
    Driven result{.omega = omega, .half = block(ahead.stiffness), .advance = block(ahead.advance)};
    result.support = SupportLaw(track.pads, track.support, group).stiffness(stiffness)[0];
    result.bay << block(bay.near), block(bay.far), block(bay.far).transpose(), block(mirrored(bay.near));
    const Complex w = rail_receptance(rail, group, workspace).at(0, 0)[0];
    result.first = {w, 0.0};
    result.supplied = -0.5 * omega * w.imag();
    return result;
}

TrackParameters uic60_track(double rail_loss, double pad_loss, double ballast_loss) {
    TrackParameters track;
    track.rail = {.beam = Beam::timoshenko,
                  .youngs_modulus_pa = 210e9,
                  .second_moment_of_area_m4 = 3038.3e-8,
                  .mass_kg_per_m = 60.2,
                  .loss_factor = rail_loss,
                  .shear_modulus_pa = 81e9,
                  .shear_coefficient = 0.4,
                  .cross_section_m2 = 60.2 / 7850.0};
    track.pads.static_stiffness_n_per_m = 300e6;
    track.pads.loss_factor = pad_loss;
    track.pads.loss_law = LossLaw::constant;
    track.support = {
        .model = SupportModel::two_layer, .mass_kg = 162.0, .stiffness_n_per_m = 50e6, .loss_factor = ballast_loss};
    return track;
}

/// Dissipation in supports and bays on both sides until it has died away, plus what still travels on where it was cut.
TEST(RadiatedPower, AllOfItIsDissipatedSomewhere) {
    for (const double rail_loss : {0.0, 0.02})
        for (const double frequency : {20.0, 90.0, 333.0, 1050.0, 2400.0, 4900.0}) {
            const Driven track = driven(uic60_track(rail_loss, 0.25, 1.0), 300e6, frequency);
            double dissipated = 0.5 * track.omega * track.support.imag() * std::norm(track.first(0));
            Pair here = track.first;
            for (int n = 0; n < 400; ++n) {
                const Pair next = track.advance * here;
                Eigen::Vector4cd ends;
                ends << here, next;
                dissipated += 2.0 * (power(track.omega, track.bay, ends) +
                                     0.5 * track.omega * track.support.imag() * std::norm(next(0)));
                here = next;
            }
            const double travelling = 2.0 * power(track.omega, track.half, here);
            // A chain of 400 products of 2×2 blocks whose entries span a factor 1e3: rounding some 1e-11.
            EXPECT_NEAR((dissipated + travelling) / track.supplied, 1.0, 1e-9)
                << frequency << " Hz, rail loss " << rail_loss;
            EXPECT_GE(travelling, -1e-9 * track.supplied);
        }
}

/// Without loss all power leaves through the two half tracks, and every cut along the way carries the same. Frequencies
/// in propagating bands; in a stop band nothing is put in.
TEST(RadiatedPower, LeavesUnchangedWithoutLoss) {
    int propagating = 0;
    for (const double frequency : {60.0, 300.0, 500.0, 800.0, 1500.0, 2600.0}) {
        const Driven track = driven(uic60_track(0.0, 0.0, 0.0), 300e6, frequency);
        const double scale = 0.5 * track.omega * std::abs(track.first(0));
        if (track.supplied < 1e-9 * scale) continue;
        ++propagating;
        Pair here = track.first;
        for (int n = 0; n < 60; ++n) {
            EXPECT_NEAR(2.0 * power(track.omega, track.half, here) / track.supplied, 1.0, 1e-9)
                << frequency << " Hz, bay " << n;
            here = track.advance * here;
        }
    }
    EXPECT_GE(propagating, 4);
}

/// Another route through linear algebra: nodes with and without loads of their own, assembled as one dense matrix
/// closed by the same two half tracks and solved by LU with pivoting, against the selected inversion in 2×2 blocks.
TEST(ExactRail, DenseAssemblyGivesTheSame) {
    const TrackParameters track = uic60_track(0.02, 0.25, 1.0);
    const std::vector<double> points{0.37, -1.1, 4.2, 2.4};
    ExactRail rail = uniform_rail(track, points, 300e6);
    for (std::size_t j = 0; j < rail.nodes.size(); ++j)
        rail.nodes[j].pad_stiffness_n_per_m *= 1.0 + 0.1 * static_cast<double>(j % 5);
    ExactRailWorkspace workspace(rail);
    const long nodes = static_cast<long>(rail.nodes.size());
    for (const double frequency : {25.0, 180.0, 1060.0, 3900.0}) {
        const lanes::Real omega = lanes::broadcast(2.0 * std::numbers::pi * frequency);
        const RailReceptance& selected = rail_receptance(rail, omega, workspace);
        const BeamCoefficients beam = beam_coefficients(track.rail, {}, omega);
        const SupportLaw law(track.pads, track.support, omega);
        const HalfTrack end = uniform_half_track(rail, omega);
        Eigen::MatrixXcd dense = Eigen::MatrixXcd::Zero(2 * nodes, 2 * nodes);
        for (long j = 0; j < nodes; ++j) {
            const RailNode& node = rail.nodes[static_cast<std::size_t>(j)];
            if (node.supported) dense(2 * j, 2 * j) += law.stiffness(node.pad_stiffness_n_per_m)[0];
            if (j + 1 == nodes) continue;
            const RailElement stretch =
                rail_element(beam, rail.nodes[static_cast<std::size_t>(j) + 1].position_m - node.position_m);
            dense.block<2, 2>(2 * j, 2 * j) += block(stretch.near);
            dense.block<2, 2>(2 * j, 2 * j + 2) += block(stretch.far);
            dense.block<2, 2>(2 * j + 2, 2 * j) += block(stretch.far).transpose();
            dense.block<2, 2>(2 * j + 2, 2 * j + 2) += block(mirrored(stretch.near));
        }
        dense.topLeftCorner<2, 2>() += block(mirrored(end.stiffness));
        dense.bottomRightCorner<2, 2>() += block(end.stiffness);
        const Eigen::MatrixXcd inverse = dense.partialPivLu().inverse();
        const auto row = [&](int point) {
            for (long j = 0; j < nodes; ++j)
                if (rail.nodes[static_cast<std::size_t>(j)].point == point) return 2 * j;
            return -1L;
        };
        // Condition of the dense matrix (forces beside moments, stiff short stretches) times rounding: some 1e-10.
        for (int a = 0; a < 4; ++a)
            for (int b = 0; b < 4; ++b)
                EXPECT_NEAR(
                    std::abs(selected.at(a, b)[0] - inverse(row(a), row(b))) / std::abs(inverse(row(a), row(a))), 0.0,
                    1e-9)
                    << frequency << " Hz " << a << b;
    }
}

}  // namespace
}  // namespace railpem::track

#include "track/statics/loaded_rail.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "parameters/parameter_error.hpp"
#include "track/elements/static_beam_element.hpp"
#include "track/pads/pad_positions.hpp"
#include "track/pads/pad_scale.hpp"

namespace railpem::track {

using Eigen::VectorXd;
using parameters::ParameterError;

namespace {

/// Unknown number of a node's deflection (0) and rotation (1); −1 for the rotations of the ends, which are zero.
int unknown(std::size_t node, int kind, std::size_t nodes) {
    if (node == 0) return kind == 0 ? 0 : -1;
    if (node == nodes - 1) return kind == 0 ? static_cast<int>(2 * nodes - 3) : -1;
    return static_cast<int>(2 * node) - 1 + kind;
}

std::array<int, 4> unknowns(std::size_t element, std::size_t nodes) {
    return {unknown(element, 0, nodes), unknown(element, 1, nodes), unknown(element + 1, 0, nodes),
            unknown(element + 1, 1, nodes)};
}

StaticBeamElement beam_element(const TrackParameters& track, double length_m) {
    const double ei = static_bending_stiffness(track);
    if (track.rail.beam == Beam::euler) return {length_m, ei, 0.0};
    const double shear = track.rail.shear_coefficient * track.rail.shear_modulus_pa * track.rail.cross_section_m2;
    return {length_m, ei, 12.0 * ei / (shear * length_m * length_m)};
}

std::vector<double> node_positions(const TrackParameters& track, const std::vector<double>& pads_m) {
    std::vector<double> nodes_m{pads_m.front() - 0.5 * track.spacing_m};
    nodes_m.insert(nodes_m.end(), pads_m.begin(), pads_m.end());
    nodes_m.push_back(pads_m.back() + 0.5 * track.spacing_m);
    return nodes_m;
}

/// Adds the wheels to the nodal loads.
void add_wheels(VectorXd& load, const TrackParameters& track, const std::vector<double>& nodes_m,
                const std::vector<double>& wheels_m, double wheel_load_n) {
    for (std::size_t w = 0; w < wheels_m.size(); ++w) {
        const double x = wheels_m[w];
        if (x < nodes_m.front() || x > nodes_m.back())
            throw ParameterError(
                "solver.pads",
                fmt::format("wheel {} stands at {:g} m, off the track, which reaches from {:g} m to {:g} m", w + 1, x,
                            nodes_m.front(), nodes_m.back()),
                "more pads");
        const auto after = std::upper_bound(nodes_m.begin() + 1, nodes_m.end() - 1, x);
        const std::size_t e = static_cast<std::size_t>(after - nodes_m.begin()) - 1;
        const double length = nodes_m[e + 1] - nodes_m[e];
        const Eigen::Vector4d shape = element_shape(beam_element(track, length), (x - nodes_m[e]) / length);
        const std::array<int, 4> at = unknowns(e, nodes_m.size());
        for (int a = 0; a < 4; ++a)
            if (at[a] >= 0) load[at[a]] += wheel_load_n * shape[a];
    }
}

SymmetricBand beam_matrix(const TrackParameters& track, const std::vector<double>& nodes_m) {
    SymmetricBand matrix = SymmetricBand::Zero(4, static_cast<Eigen::Index>(2 * nodes_m.size()) - 2);
    for (std::size_t e = 0; e + 1 < nodes_m.size(); ++e) {
        const Eigen::Matrix4d k = element_stiffness(beam_element(track, nodes_m[e + 1] - nodes_m[e]));
        const std::array<int, 4> at = unknowns(e, nodes_m.size());
        for (int a = 0; a < 4; ++a)
            for (int b = 0; b < 4; ++b)
                if (at[b] >= 0 && at[a] >= at[b]) matrix(at[a] - at[b], at[b]) += k(a, b);
    }
    return matrix;
}

VectorXd rail_weight(const TrackParameters& track, const std::vector<double>& nodes_m) {
    VectorXd load = VectorXd::Zero(static_cast<Eigen::Index>(2 * nodes_m.size()) - 2);
    const double weight_n_per_m = rest_load_n(track) / track.spacing_m;
    for (std::size_t e = 0; e + 1 < nodes_m.size(); ++e) {
        const StaticBeamElement element = beam_element(track, nodes_m[e + 1] - nodes_m[e]);
        const Eigen::Vector4d weight = weight_n_per_m * element_uniform_load(element);
        const std::array<int, 4> at = unknowns(e, nodes_m.size());
        for (int a = 0; a < 4; ++a)
            if (at[a] >= 0) load[at[a]] += weight[a];
    }
    return load;
}

}  // namespace

LoadedRail loaded_rail(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n,
                       const std::vector<double>& pads_m) {
    const std::vector<double> nodes_m = node_positions(track, pads_m);
    LoadedRail rail;
    rail.stiffness = beam_matrix(track, nodes_m);
    rail.load = rail_weight(track, nodes_m);
    add_wheels(rail.load, track, nodes_m, wheels_m, wheel_load_n);
    rail.seat = seat_law(track);
    for (const double x : pads_m) rail.scale.push_back(pad_scale(track, seat_index(track, wheels_m, x)));
    rail.largest_load_n = std::max({std::abs(wheel_load_n), rest_load_n(track), track.statics.clip_preload_n});
    return rail;
}

}  // namespace railpem::track

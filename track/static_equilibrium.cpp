#include "track/static_equilibrium.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "parameters/parameter_error.hpp"
#include "track/pad_scale.hpp"
#include "track/seat_law.hpp"
#include "track/static_beam_element.hpp"
#include "track/symmetric_band.hpp"

namespace railpem::track {

using Eigen::VectorXd;
using parameters::ParameterError;

namespace {

/// The rail on its pads, deflections and loads positive downwards. Nodes: the rear end, the pads, the front end. Wheels
/// need no node of their own. The ends lie mid-bay beyond the outermost pads and do not rotate: the track goes on
/// uniformly.
struct LoadedRail {
    SymmetricBand stiffness;  ///< of the beam
    VectorXd load;            ///< rail weight and wheels
    SeatLaw seat;
    std::vector<double> scale;  ///< per pad, what a failed fastener has left
    double largest_load_n = 0.0;

    static int deflection(std::size_t pad) { return static_cast<int>(2 * pad + 1); }
    std::size_t pads() const { return scale.size(); }
};

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

LoadedRail assemble(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n,
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

/// Where a deflection leads: the loads that nothing balances yet, N and N·m, the negative gradient of the potential energy; and the
/// tangents of the seats. Both at once, for a seat on a support costs an iteration of its own.
struct Unbalanced {
    VectorXd load;
    std::vector<double> tangent_n_per_m;
};

Unbalanced unbalanced(const LoadedRail& rail, const VectorXd& u) {
    Unbalanced result{rail.load - multiply(rail.stiffness, u), std::vector<double>(rail.pads())};
    for (std::size_t j = 0; j < rail.pads(); ++j) {
        const int at = LoadedRail::deflection(j);
        const SeatState seat = seat_state(rail.seat, rail.scale[j], u[at]);
        result.load[at] -= seat.force_on_rail_n;
        result.tangent_n_per_m[j] = seat.tangent_n_per_m;
    }
    return result;
}

/// Goes along a Newton step, as far as is good. F(S) never falls, so the potential energy is convex and its slope along the step,
/// −r·d, rises steadily: a step that ends before the minimum is taken as it is, one that overshoots is halved until the
/// slope behind the minimum is at most half of what it was at the start (Crisfield 1991, section 9.2).
void advance(const LoadedRail& rail, const VectorXd& step, VectorXd& u, Unbalanced& state) {
    const double at_start = state.load.dot(step);
    const VectorXd start = u;
    double length = 1.0;
    u = start + step;
    state = unbalanced(rail, u);
    for (int i = 0; i < 60 && state.load.dot(step) < -0.5 * at_start; ++i) {
        length *= 0.5;
        u = start + length * step;
        state = unbalanced(rail, u);
    }
}

/// Largest unbalanced nodal load, N; moments count over half a bay.
double residual_n(const LoadedRail& rail, const VectorXd& r, double spacing_m) {
    double largest = std::max(std::abs(r[0]), std::abs(r[r.size() - 1]));
    for (std::size_t j = 0; j < rail.pads(); ++j) {
        const int at = LoadedRail::deflection(j);
        largest = std::max({largest, std::abs(r[at]), std::abs(r[at + 1]) / (0.5 * spacing_m)});
    }
    return largest;
}

struct NewtonResult {
    VectorXd deflection;
    int iterations = 0;
    double residual_n = 0.0;
};

[[noreturn]] void refuse() {
    throw ParameterError("track", "rail, wheels and pads find no static equilibrium",
                         "fewer failed fasteners, stiffer pads or a smaller wheel load");
}

/// Solves unbalanced(u) = 0, starting from `start` or, if that is empty, from the unloaded track. The tangent is positive definite as long as anything carries.
NewtonResult newton(const LoadedRail& rail, const std::vector<double>& start, double rest_deflection_m, double spacing_m) {
    constexpr int most_iterations =
        200;  // 5 to 10 are usual; a rail that lifts off and settles again may need some tens
    // Rounding in the beam's own forces, about EI·u/h³·1e-16, stays two orders below.
    const double tolerance = 1e-10 * rail.largest_load_n;
    NewtonResult result{VectorXd::Zero(rail.load.size()), 0, 0.0};
    VectorXd& u = result.deflection;
    u[0] = u[u.size() - 1] = rest_deflection_m;
    for (std::size_t j = 0; j < rail.pads(); ++j) u[LoadedRail::deflection(j)] = rest_deflection_m;
    if (static_cast<Eigen::Index>(start.size()) == u.size()) u = Eigen::Map<const VectorXd>(start.data(), u.size());

    for (Unbalanced state = unbalanced(rail, u); result.iterations < most_iterations; ++result.iterations) {
        result.residual_n = residual_n(rail, state.load, spacing_m);
        if (result.residual_n <= tolerance) return result;
        SymmetricBand tangent = rail.stiffness;
        for (std::size_t j = 0; j < rail.pads(); ++j) tangent(0, LoadedRail::deflection(j)) += state.tangent_n_per_m[j];
        VectorXd step = state.load;
        if (!solve_in_place(tangent, step)) refuse();
        advance(rail, step, u, state);
    }
    refuse();
}

/// K0 = ratio·[(1 − s)·K_secant + s·K(S)], cut at zero: with s > 1 the law would give unloaded pads a negative
/// stiffness.
double initial_dynamic_stiffness(const PadParameters& pads, double static_stiffness) {
    const double s = pads.preload_strength;
    return pads.dynamic_to_static_ratio *
           std::max(0.0, (1.0 - s) * pads.static_stiffness_n_per_m + s * static_stiffness);
}

void warn(StaticEquilibrium& result, const LoadedRail& rail) {
    std::size_t lifted = 0, beyond = 0;
    double largest_gap = 0.0, gap_at = 0.0;
    for (std::size_t j = 0; j < rail.pads(); ++j) {
        if (rail.scale[j] == 0.0) continue;  // nothing there to lift from
        const double gap = rail.seat.curve.free_compression_m - result.compression_m[j];
        if (gap >= 0.0) ++lifted;
        if (gap > largest_gap) largest_gap = gap, gap_at = 1e-6 * std::round(1e6 * result.position_m[j]) + 0.0;
        if (result.compression_m[j] > rail.seat.curve.limit_compression_m) ++beyond;
    }
    if (lifted > 0)
        result.warnings.push_back(
            fmt::format("the rail lifts off {} pad(s), most of all by {:.3g} mm at {:g} m; they carry nothing", lifted,
                        1e3 * largest_gap, gap_at));
    if (beyond > 0)
        result.warnings.push_back(
            fmt::format("{} pad(s) carry more than {:g} kN, the end of the static curve; its tangent goes on", beyond,
                        1e-3 * rail.seat.curve.limit_force_n));
}

}  // namespace

StaticEquilibrium static_equilibrium(const TrackParameters& track, const std::vector<double>& wheels_m,
                                     double wheel_load_n, const std::vector<double>& pads_m, const StaticEquilibrium* start) {
    assert(!pads_m.empty() && std::is_sorted(pads_m.begin(), pads_m.end()));
    const LoadedRail rail = assemble(track, wheels_m, wheel_load_n, pads_m);
    const SeatState unloaded = unloaded_seat(rail.seat, rest_load_n(track));
    const NewtonResult found = newton(rail, start ? start->deflection : std::vector<double>{}, unloaded.displacement_m, track.spacing_m);

    StaticEquilibrium result;
    result.position_m = pads_m;
    result.remaining_fraction = rail.scale;
    for (std::size_t j = 0; j < pads_m.size(); ++j) {
        const double u = found.deflection[LoadedRail::deflection(j)];
        const double compression = seat_state(rail.seat, rail.scale[j], u).compression_m;
        const double stiffness = pad_stiffness(rail.seat.curve, compression);
        result.compression_m.push_back(compression);
        result.static_stiffness_n_per_m.push_back(stiffness);
        result.dynamic_stiffness_n_per_m.push_back(initial_dynamic_stiffness(track.pads, stiffness));
    }
    result.unloaded_compression_m = unloaded.compression_m;
    result.unloaded_static_stiffness_n_per_m = pad_stiffness(rail.seat.curve, unloaded.compression_m);
    result.unloaded_dynamic_stiffness_n_per_m =
        initial_dynamic_stiffness(track.pads, result.unloaded_static_stiffness_n_per_m);
    result.deflection.assign(found.deflection.begin(), found.deflection.end());
    result.iterations = found.iterations;
    result.residual_n = found.residual_n;
    warn(result, rail);
    return result;
}

StaticEquilibrium load_independent_pads(const TrackParameters& track, const std::vector<double>& pads_m) {
    assert(track.pads.preload_strength == 0.0);
    StaticEquilibrium result;
    result.position_m = pads_m;
    result.unloaded_dynamic_stiffness_n_per_m = initial_dynamic_stiffness(track.pads, 0.0);
    result.dynamic_stiffness_n_per_m.assign(pads_m.size(), result.unloaded_dynamic_stiffness_n_per_m);
    return result;
}

}  // namespace railpem::track

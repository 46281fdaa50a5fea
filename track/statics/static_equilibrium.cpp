#include "track/statics/static_equilibrium.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "parameters/parameter_error.hpp"
#include "track/pads/pad_law.hpp"
#include "track/statics/loaded_rail.hpp"

namespace railpem::track {

using Eigen::VectorXd;
using parameters::ParameterError;

namespace {

/// Where a deflection leads: the loads that nothing balances yet, N and N·m, the negative gradient of the potential
/// energy; and the tangents of the seats. Both at once, for a seat on a support costs an iteration of its own.
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

/// Goes along a Newton step, as far as is good. F(S) never falls, so the potential energy is convex and its slope along
/// the step, −r·d, rises steadily: a step that ends before the minimum is taken as it is, one that overshoots is halved
/// until the slope behind the minimum is at most half of what it was at the start (Crisfield 1991, section 9.2).
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

/// Solves unbalanced(u) = 0, starting from `start` or, if that is empty, from the unloaded track. The tangent is
/// positive definite as long as anything carries.
NewtonResult newton(const LoadedRail& rail, const std::vector<double>& start, double rest_deflection_m,
                    double spacing_m) {
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
                                     double wheel_load_n, const std::vector<double>& pads_m,
                                     const StaticEquilibrium* start) {
    assert(!pads_m.empty() && std::is_sorted(pads_m.begin(), pads_m.end()));
    const LoadedRail rail = loaded_rail(track, wheels_m, wheel_load_n, pads_m);
    const SeatState unloaded = unloaded_seat(rail.seat, rest_load_n(track));
    const NewtonResult found =
        newton(rail, start ? start->deflection : std::vector<double>{}, unloaded.displacement_m, track.spacing_m);

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

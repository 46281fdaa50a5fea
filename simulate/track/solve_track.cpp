#include "simulate/track/solve_track.hpp"

#include <algorithm>

#include "simulate/track/footing.hpp"

namespace railpem::simulate {

namespace {

/// On its own part of the track: a pad on a sleeper scatters by itself and the ballast under it; where the pad stands
/// for all, pad and ground scatter in series. The dashpot of a pad is independent of both.
void scatter_seat(Seat& seat, const SeatLaw& law, const SeatScatter& scatter, std::int64_t number) {
    const double factor = scatter.seat_factor(number);
    seat.share *= factor;
    seat.dashpot_scale = scatter.dashpot_factor(number) / factor;
    if (law.supported) seat.oscillator_scale.front() *= scatter.support_factor(number);
}

void set_seat(TrackWindow& track, std::size_t i, const RadauStep& step) {
    const std::int64_t number = track.first_seat + static_cast<std::int64_t>(i);
    Seat& seat = track.seats[i];
    const SeatVariation& variation = track.variation;
    seat.share = variation.has_failed(number) ? variation.remaining_share : 1.0;
    if (!seat.oscillator_scale.empty()) seat.oscillator_scale.back() = variation.ground_scale(number);
    if (variation.scatter.any()) scatter_seat(seat, track.law, variation.scatter, number);
    set_stiffness(seat, track.law, track.seat_numbers, step);
}

/// Puts the tangent at each pad's present compression into the matrix: fewer iterations, the same solution.
void retune(TrackWindow& track, const RadauStep& step) {
    for (Seat& seat : track.seats) {
        const double tangent = track.law.curve.tangent(seat.origin_m + seat.compression_m);
        seat.residual += (seat.reference_stiffness_n_per_m - tangent) * seat.compression;
        seat.reference_stiffness_n_per_m = tangent;
        set_stiffness(seat, track.law, track.seat_numbers, step);
    }
}

}  // namespace

void assemble(TrackWindow& track, const RadauStep& step) {
    const std::size_t n = track.nodes();
    const Complex s2 = step.s * step.s;
    const Complex elastic = 1.0 + track.rail_loss_s * step.s;
    const auto entry = [&](int row, int column) {
        return s2 * track.mass(row, column) + elastic * track.stiffness(row, column);
    };
    // The rail goes on by one element to a clamped end at either side, far in the absorber: every node has two
    // elements.
    const Complex coupled = entry(0, 1) + entry(2, 3);
    const Block diagonal{entry(0, 0) + entry(2, 2), coupled, coupled, entry(1, 1) + entry(3, 3)};
    const Block upper{entry(0, 2), entry(0, 3), entry(1, 2), entry(1, 3)};
    track.rail.diagonal.assign(n, diagonal);
    track.rail.upper.assign(n - 1, upper);
    for (DamperLaw& damper : track.dampers) {
        damper.coupling = damper.stiffness_n_per_m + damper.damping_n_s_per_m * step.s;
        damper.receptance = 1.0 / (damper.mass_kg * s2 + damper.coupling);
    }
    for (std::size_t k = 0; k < n; ++k) {
        track.rail.diagonal[k][0] += step.s * track.absorber_n_s_per_m[k];
        for (const DamperLaw& damper : track.dampers)
            track.rail.diagonal[k][0] += damper.coupling * damper.mass_kg * s2 * damper.receptance;
    }
    track.seat_numbers = seat_step(track.law, step);
    for (std::size_t i = 0; i < track.seats.size(); ++i) set_seat(track, i, step);
    track.history.resize(n);
    track.solution.resize(n);
    track.damper_history.assign(track.dampers.size(), std::vector<Complex>(n));
    factorise_track(track);
}

void factorise_track(TrackWindow& track) {
    BlockTridiagonal whole = track.rail;
    for (std::size_t i = 0; i < track.seats.size(); ++i)
        whole.diagonal[i * static_cast<std::size_t>(track.elements_per_bay)][0] += track.seats[i].condensed_stiffness;
    factorise(whole, track.factors);
}

void shift(TrackWindow& track, const RadauStep& step) {
    const auto by = static_cast<std::ptrdiff_t>(track.elements_per_bay);
    for (std::vector<double>* values : {&track.w, &track.theta, &track.velocity_w, &track.velocity_theta}) {
        std::copy(values->begin() + by, values->end(), values->begin());
        std::fill(values->end() - by, values->end(), 0.0);
    }
    for (std::vector<Motion>& motion : track.damper_motion) {
        std::copy(motion.begin() + by, motion.end(), motion.begin());
        std::fill(motion.end() - by, motion.end(), Motion{});
    }
    std::rotate(track.seats.begin(), track.seats.begin() + 1, track.seats.end());
    track.seats.back() = fresh_seat(track.law);
    ++track.first_seat;
    set_seat(track, track.seats.size() - 1, step);
    if (track.law.nonlinear) retune(track, step);
    if (track.law.nonlinear || !track.variation.is_uniform()) factorise_track(track);
}

namespace {

/// 1̂·s·(M·(s·u + u̇) + C·u) of the rail with its absorber, node by node.
void rail_history(TrackWindow& track, const RadauStep& step) {
    const std::size_t n = track.nodes();
    const Eigen::Matrix4d& m = track.mass;
    const Eigen::Matrix4d damping = track.rail_loss_s * track.stiffness;
    const bool lossy = track.rail_loss_s > 0.0;
    const Complex scale = product(step.one, step.s);
    // Rows of a symmetric element matrix gathered at node k from the elements before and after it.
    const auto gather = [n](const Eigen::Matrix4d& e, const std::vector<double>& w, const std::vector<double>& t,
                            std::size_t k) {
        const double w0 = k > 0 ? w[k - 1] : 0.0;
        const double t0 = k > 0 ? t[k - 1] : 0.0;
        const double w2 = k + 1 < n ? w[k + 1] : 0.0;
        const double t2 = k + 1 < n ? t[k + 1] : 0.0;
        const double force = (e(0, 0) + e(2, 2)) * w[k] + e(0, 2) * (w0 + w2) + e(0, 3) * t2 + e(1, 2) * t0;
        const double couple = (e(1, 1) + e(3, 3)) * t[k] + e(1, 3) * (t0 + t2) + e(1, 2) * w2 + e(0, 3) * w0;
        return std::pair{force, couple};
    };
    for (std::size_t k = 0; k < n; ++k) {
        const auto [force_u, couple_u] = gather(m, track.w, track.theta, k);
        auto [force_v, couple_v] = gather(m, track.velocity_w, track.velocity_theta, k);
        force_v += track.absorber_n_s_per_m[k] * track.w[k];
        if (lossy) {
            const auto [force_c, couple_c] = gather(damping, track.w, track.theta, k);
            force_v += force_c;
            couple_v += couple_c;
        }
        track.history[k] = {product(scale, step.s * force_u + force_v), product(scale, step.s * couple_u + couple_v)};
    }
}

void damper_history(TrackWindow& track, const RadauStep& step) {
    const Complex scale = product(step.one, step.s);
    for (std::size_t d = 0; d < track.dampers.size(); ++d) {
        const DamperLaw& law = track.dampers[d];
        for (std::size_t k = 0; k < track.nodes(); ++k) {
            const Motion& y = track.damper_motion[d][k];
            const Complex dashpot = scale * (law.damping_n_s_per_m * (y.displacement_m - track.w[k]));
            const Complex momentum =
                product(scale, step.s * (law.mass_kg * y.displacement_m) + law.mass_kg * y.velocity_m_per_s);
            track.damper_history[d][k] = dashpot + momentum;
            track.history[k].w += product(product(law.coupling, law.receptance), dashpot + momentum) - dashpot;
        }
    }
}

}  // namespace

void begin_step(TrackWindow& track, const RadauStep& step) {
    rail_history(track, step);
    if (!track.dampers.empty()) damper_history(track, step);
    for (Seat& seat : track.seats) begin_step(seat, track.law, track.seat_numbers, step);
}

double solve_track(TrackWindow& track, const RadauStep& step, const std::vector<StageLoad>& loads) {
    const auto by = static_cast<std::size_t>(track.elements_per_bay);
    track.solution = track.history;
    for (std::size_t i = 0; i < track.seats.size(); ++i) track.solution[i * by].w += applied_force(track.seats[i]);
    for (const StageLoad& load : loads)
        for (std::size_t stage = 0; stage < 2; ++stage) {
            const Footing on = footing(track, load, stage);
            for (std::size_t part = 0; part < on.count; ++part) {
                const auto& [at, share] = on.parts[part];
                const Complex force = (stage == 0 ? step.tau1 : step.tau2) * (share * load.force_n[stage]);
                track.solution[at.node].w -= at.shape[0] * force;
                track.solution[at.node].theta -= at.shape[1] * force;
                track.solution[at.node + 1].w -= at.shape[2] * force;
                track.solution[at.node + 1].theta -= at.shape[3] * force;
            }
        }
    solve(track.factors, track.solution);
    double moved = 0.0;
    for (std::size_t i = 0; i < track.seats.size(); ++i)
        moved = std::max(moved, respond(track.seats[i], track.law, step, track.solution[i * by].w));
    return moved;
}

std::array<double, 2> rail_displacement(const TrackWindow& track, const RadauStep& step, const StageLoad& load) {
    std::array<double, 2> value{};
    for (std::size_t stage = 0; stage < 2; ++stage) {
        const Footing on = footing(track, load, stage);
        Complex sum{};
        for (std::size_t part = 0; part < on.count; ++part) {
            const auto& [at, share] = on.parts[part];
            const Pair& a = track.solution[at.node];
            const Pair& b = track.solution[at.node + 1];
            sum += share * (at.shape[0] * a.w + at.shape[1] * a.theta + at.shape[2] * b.w + at.shape[3] * b.theta);
        }
        value[stage] = stage == 0 ? step.at_first(sum) : RadauStep::at_end(sum);
    }
    return value;
}

void finish_step(TrackWindow& track, const RadauStep& step) {
    for (std::size_t d = 0; d < track.dampers.size(); ++d)
        for (std::size_t k = 0; k < track.nodes(); ++k) {
            const DamperLaw& law = track.dampers[d];
            const Complex y =
                product(law.receptance, product(law.coupling, track.solution[k].w) + track.damper_history[d][k]);
            Motion& motion = track.damper_motion[d][k];
            motion = {RadauStep::at_end(y), RadauStep::at_end(step.derivative(y, motion.displacement_m))};
        }
    for (Seat& seat : track.seats) finish_step(seat, track.law, track.seat_numbers, step);
    for (std::size_t k = 0; k < track.nodes(); ++k) {
        const Pair& u = track.solution[k];
        track.velocity_w[k] = RadauStep::at_end(step.derivative(u.w, track.w[k]));
        track.velocity_theta[k] = RadauStep::at_end(step.derivative(u.theta, track.theta[k]));
        track.w[k] = RadauStep::at_end(u.w);
        track.theta[k] = RadauStep::at_end(u.theta);
    }
}

}  // namespace railpem::simulate

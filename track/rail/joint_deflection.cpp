#include "track/rail/joint_deflection.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace railpem::track {

using lanes::Complex;

namespace {

/// A unit force in the bay: into what is behind the next pad; to be called before cross_bay().
WavePair forced(const BayPoint& point, const WavePair& excited, const BayFactors& bay, const Behind& behind) {
    const auto& [p1, p2] = point.from_rear;
    return {bay.first * (behind.e[0] + behind.s11 * p1 + behind.s12 * p2) + excited[0] * point.from_front[0],
            bay.second * (behind.e[1] + behind.s12 * p1 + behind.s22 * p2) + excited[1] * point.from_front[1]};
}

/// On the way back across a bay with a point: its deflection. β is that over the pad ahead, and becomes that over the
/// pad behind.
Complex deflection(const BayPoint& point, const WavePair& excited, const BayFactors& bay, const Behind& behind,
                   WavePair& beta) {
    Complex w = point.own;
    for (std::size_t i = 0; i < 2; ++i) w += point.from_front[i] * excited[i] * beta[i];
    beta = {beta[0] * bay.first + point.from_rear[0], beta[1] * bay.second + point.from_rear[1]};
    w += point.from_rear[0] * (behind.s11 * beta[0] + behind.s12 * beta[1] + behind.e[0]);
    w += point.from_rear[1] * (behind.s12 * beta[0] + behind.s22 * beta[1] + behind.e[1]);
    return w;
}

/// Of a wave that goes to a seat and comes back: below it the seat is not felt.
constexpr double kUnfelt = 1e-13;

/// Bays over which a wave and its echo have decayed below that in every lane.
std::size_t felt_bays(const WavePair& factor) {
    double largest = 0.0;
    for (int lane = 0; lane < lanes::width; ++lane)
        largest = std::max({largest, lanes::norm(factor[0])[lane], lanes::norm(factor[1])[lane]});
    if (!(largest < 1.0)) return std::numeric_limits<std::size_t>::max() / 2;
    return static_cast<std::size_t>(std::log(kUnfelt) / std::log(largest)) + 2;
}

/// `Count` rows in step: one waits for the division of its last seat while the other computes.
template <std::size_t Count>
void sweep(const BlochWaves& waves, const SupportLaw::Change& change, double uniform,
           const std::vector<Seat>* const* rows, const PlacedPoints& placed, std::span<const BayPoint> points,
           ScatterRow& memory, Complex* result, double tolerance) {
    const BayFactors bay(waves.factor);
    const std::size_t count = placed.points.size(), felt = felt_bays(waves.factor);
    // What is so far behind the rearmost point or ahead of the foremost that no echo of it is left is not looked at.
    const std::size_t rear = placed.points.front().seat > felt ? placed.points.front().seat - felt : 0;
    const std::size_t seats = std::min(rows[0]->size(), placed.points.back().seat + felt + 1);
    std::array<Behind, Count> behind{};
    std::array<std::array<Behind, Count>, kMostPoints> at_point;
    const auto differs = [&](const Seat& seat) {
        return seat.scale != 1.0 || std::abs(seat.pad_stiffness_n_per_m - uniform) > tolerance * uniform;
    };
    const std::size_t loaded = placed.points.front().seat + 1;  // behind it nothing pushes, and the way back ends there
    for (std::size_t j = rear; j < loaded; ++j)
        for (std::size_t t = 0; t < Count; ++t) {
            if (j > rear) cross_bay_unloaded(bay, behind[t]);
            const Seat& seat = (*rows[t])[j];
            Complex u1, u2;
            if (differs(seat))
                scatter_unloaded(waves.excited, change.numerator(seat.pad_stiffness_n_per_m, seat.scale),
                                 change.denominator(seat.pad_stiffness_n_per_m, seat.scale), behind[t], u1, u2);
        }
    std::size_t point = 0;
    for (std::size_t j = loaded - 1; j < seats; ++j) {
        for (std::size_t t = 0; t < Count && j >= loaded; ++t) {
            const Seat& seat = (*rows[t])[j];
            memory[j][t] = differs(seat)
                               ? scatter(waves.excited, change.numerator(seat.pad_stiffness_n_per_m, seat.scale),
                                         change.denominator(seat.pad_stiffness_n_per_m, seat.scale),
                                         behind[t].e[0] + behind[t].e[1], behind[t])
                               : Scatter{};
        }
        const bool has_point = point < count && placed.points[point].seat == j;
        for (std::size_t t = 0; t < Count; ++t) {
            if (!has_point) {
                cross_bay(bay, behind[t]);
                continue;
            }
            at_point[point][t] = behind[t];
            const WavePair e = forced(points[point], waves.excited, bay, behind[t]);
            cross_bay_unloaded(bay, behind[t]);
            behind[t].e = e;
        }
        if (has_point) ++point;
    }
    assert(point == count);
    std::array<WavePair, Count> beta{};
    for (std::size_t j = seats; point > 0;) {
        --j;
        const bool has_point = point > 0 && placed.points[point - 1].seat == j;
        if (has_point) --point;
        for (std::size_t t = 0; t < Count; ++t) {
            WavePair& b = beta[t];
            if (has_point)
                result[t * count + placed.order[point]] =
                    deflection(points[point], waves.excited, bay, at_point[point][t], b);
            else
                b = {b[0] * bay.first, b[1] * bay.second};
            if (point == 0) continue;
            const Scatter& seat = memory[j][t];
            const Complex force = seat.strength[0] * b[0] + seat.strength[1] * b[1] + seat.load;
            b[0] -= force;
            b[1] -= force;
        }
    }
}

}  // namespace

std::optional<PlacedPoints> place_points(const std::vector<Seat>& seats, const std::vector<double>& points_m,
                                         double spacing_m) {
    assert(points_m.size() <= kMostPoints);
    PlacedPoints placed;
    placed.order.resize(points_m.size());
    std::iota(placed.order.begin(), placed.order.end(), std::size_t{0});
    std::sort(placed.order.begin(), placed.order.end(),
              [&](std::size_t a, std::size_t b) { return points_m[a] < points_m[b]; });
    for (const std::size_t i : placed.order) {
        const double bays = (points_m[i] - seats.front().position_m) / spacing_m;
        const std::size_t seat = static_cast<std::size_t>(std::floor(bays + kSameNode / spacing_m));
        assert(bays > -kSameNode && seat < seats.size());
        if (!placed.points.empty() && placed.points.back().seat == seat) return std::nullopt;
        const double ahead = points_m[i] - seats[seat].position_m;
        placed.points.push_back({seat, ahead < kSameNode ? 0.0 : ahead});
    }
    return placed;
}

void joint_deflection(const BlochWaves& waves, const SupportLaw& law, double uniform_pad_stiffness_n_per_m,
                      std::span<const std::vector<Seat>* const> rows, const PlacedPoints& placed,
                      std::span<const BayPoint> points, ScatterRow& memory, Complex* result, double tolerance) {
    assert(points.size() == placed.points.size());
    memory.resize(rows.front()->size());
    const std::size_t count = placed.points.size();
    const SupportLaw::Change change = law.change_from(uniform_pad_stiffness_n_per_m);
    std::size_t r = 0;
    for (; r + 2 <= rows.size(); r += 2)
        sweep<2>(waves, change, uniform_pad_stiffness_n_per_m, rows.data() + r, placed, points, memory,
                 result + r * count, tolerance);
    if (r < rows.size())
        sweep<1>(waves, change, uniform_pad_stiffness_n_per_m, rows.data() + r, placed, points, memory,
                 result + r * count, tolerance);
}

}  // namespace railpem::track

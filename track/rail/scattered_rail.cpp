#include "track/rail/scattered_rail.hpp"

#include <algorithm>
#include <cmath>

namespace railpem::track {

using lanes::Complex;
using lanes::Matrix2;

namespace {

/// Of the amplitudes that a force sends out, smaller to larger, squared: below it one of them is rounding.
constexpr double kLeastShare = 1e-16;

bool both_excited(const WavePair& excited) {
    const lanes::Real first = lanes::norm(excited[0]), second = lanes::norm(excited[1]);
    for (int lane = 0; lane < lanes::width; ++lane)
        if (!(first[lane] > kLeastShare * second[lane] && second[lane] > kLeastShare * first[lane])) return false;
    return true;
}

/// What every seat needs of one group of lines.
struct Row {
    const ScatteredRail& rail;
    const WavePair& excited;
    BayFactors bay;
    SupportLaw::Change change;
    Complex missing;  ///< of the uniform deflection to 1: the seats that differ are driven by it

    /// Over a bay, unless it is the first seat of the sweep, and through the seat.
    [[gnu::always_inline]] Scatter pass(std::size_t j, bool first, Behind& behind) const {
        if (!first) cross_bay(bay, behind);
        const ScatteredRail::Seat& seat = rail.seats[j];
        if (!seat.differs) return {};
        return scatter(excited, change.numerator(seat.pad_stiffness_n_per_m, seat.scale),
                       change.denominator(seat.pad_stiffness_n_per_m, seat.scale), behind.e[0] + behind.e[1] + missing,
                       behind);
    }
};

using Sides = std::array<Behind, kMostPoints>;

/// Behind and ahead of the bay of every point. The two sweeps are independent: one waits for its division while the
/// other computes.
void sweep(const Row& row, std::vector<WavePair>& strength, Sides& behind_of, Sides& ahead_of) {
    const std::vector<PlacedPoint>& points = row.rail.placed.points;
    const std::size_t seats = row.rail.seats.size(), from_rear = points.back().seat + 1,
                      from_front = seats - 1 - points.front().seat;
    strength.resize(seats);
    Behind behind{}, ahead{};
    std::size_t next_behind = 0, next_ahead = points.size();
    for (std::size_t k = 0; k < std::max(from_rear, from_front); ++k) {
        if (k < from_rear) strength[k] = row.pass(k, k == 0, behind).strength;
        const std::size_t j = seats - 1 - k;
        if (k < from_front) row.pass(j, k == 0, ahead);
        if (next_behind < points.size() && points[next_behind].seat == k) behind_of[next_behind++] = behind;
        if (next_ahead > 0 && points[next_ahead - 1].seat + 1 == j) ahead_of[--next_ahead] = ahead;
    }
}

Complex dot(const WavePair& x, const WavePair& y) {
    return x[0] * y[0] + x[1] * y[1];
}

WavePair times(const Behind& side, const WavePair& x) {
    return {side.s11 * x[0] + side.s12 * x[1], side.s12 * x[0] + side.s22 * x[1]};
}

/// Waves about a point under a unit force there.
struct Driven {
    WavePair backward;  ///< β over the pad behind it
    Complex own;        ///< deflection
    Complex settled;    ///< deflection when every seat is loaded with its own stiffness and no force acts
};

/// `over`: Λq⁻¹.
Driven drive(const BayPoint& point, const WavePair& over, const Behind& behind, const Behind& ahead,
             const Complex& uniform) {
    const Matrix2 s{over[0] * behind.s11, over[0] * behind.s12, over[1] * behind.s12, over[1] * behind.s22};
    const Matrix2 q{over[0] * ahead.s11, over[0] * ahead.s12, over[1] * ahead.s12, over[1] * ahead.s22};
    Matrix2 round = Matrix2{} - q * s;
    round.a = round.a + 1.0;
    round.d = round.d + 1.0;
    const Matrix2 closed = lanes::inverse(round);
    const auto solve = [&](const WavePair& to_rear, const WavePair& to_front, WavePair& beta, WavePair& alpha) {
        const lanes::Vector2 front{to_front[0], to_front[1]};
        const lanes::Vector2 b = closed * (q * front + lanes::Vector2{to_rear[0], to_rear[1]}), a = s * b + front;
        beta = {b.a, b.b};
        alpha = {a.a, a.b};
    };
    Driven driven;
    WavePair alpha, beta;
    solve(point.from_rear, point.from_front, driven.backward, alpha);
    driven.own =
        point.own + dot(point.from_rear, times(behind, driven.backward)) + dot(point.from_front, times(ahead, alpha));
    solve({over[0] * ahead.e[0], over[1] * ahead.e[1]}, {over[0] * behind.e[0], over[1] * behind.e[1]}, beta, alpha);
    const WavePair a = times(behind, beta), b = times(ahead, alpha);
    driven.settled = uniform * point.lifted + dot(point.from_rear, {a[0] + behind.e[0], a[1] + behind.e[1]}) +
                     dot(point.from_front, {b[0] + ahead.e[0], b[1] + ahead.e[1]});
    return driven;
}

/// Backward waves of `count` forces further in front, from just ahead of seat `from` to just behind seat `to`, both
/// crossed.
void travel_back(const BayFactors& bay, const std::vector<WavePair>& strength, std::size_t from, std::size_t to,
                 std::size_t count, std::array<WavePair, kMostPoints>& beta) {
    for (std::size_t j = from;; --j) {
        for (std::size_t k = 0; k < count; ++k) {
            const Complex force = dot(strength[j], beta[k]);
            beta[k] = {beta[k][0] - force, beta[k][1] - force};
            if (j > to) beta[k] = {beta[k][0] * bay.first, beta[k][1] * bay.second};
        }
        if (j == to) return;
    }
}

std::array<BayPoint, kMostPoints> bay_points(const PlacedPoints& placed, const BlochWaves& waves) {
    std::array<BayPoint, kMostPoints> points;
    for (std::size_t k = 0; k < placed.points.size(); ++k) {
        // Wheels that stand alike in their bays, as they do where the distances are whole numbers of bays, share the
        // shape.
        const bool alike = k > 0 && std::abs(placed.points[k].ahead_m - placed.points[k - 1].ahead_m) < 1e-12;
        points[k] = alike ? points[k - 1] : bay_point(waves, placed.points[k].ahead_m);
    }
    return points;
}

}  // namespace

std::optional<ScatteredRail> scattered_rail(const ExactRail& rail, double tolerance) {
    ScatteredRail scattered;
    const double uniform = rail.uniform_pad_stiffness_n_per_m;
    bool any = false;
    double seat_position = 0.0;
    for (const RailNode& node : rail.nodes) {
        if (node.supported) {
            const bool differs =
                node.pad_scale != 1.0 || std::abs(node.pad_stiffness_n_per_m - uniform) > tolerance * uniform;
            scattered.seats.push_back({node.pad_stiffness_n_per_m, node.pad_scale, differs});
            seat_position = node.position_m;
            any |= differs;
        }
        if (node.point < 0) continue;
        std::vector<PlacedPoint>& points = scattered.placed.points;
        if (scattered.seats.empty() || points.size() == kMostPoints) return std::nullopt;
        const std::size_t seat = scattered.seats.size() - 1;
        if (!points.empty() && points.back().seat == seat) return std::nullopt;
        points.push_back({seat, node.supported ? 0.0 : node.position_m - seat_position});
        scattered.placed.order.push_back(static_cast<std::size_t>(node.point));
    }
    // A seat has to stand ahead of the foremost point.
    if (!any || scattered.placed.points.empty() || scattered.placed.points.back().seat + 1 >= scattered.seats.size())
        return std::nullopt;
    return scattered;
}

bool scattered_receptance(const ScatteredRail& rail, const BlochWaves& waves, const SupportLaw& law,
                          double uniform_pad_stiffness_n_per_m, ScatteredWorkspace& work, RailReceptance& result) {
    if (!apart(waves) || !both_excited(waves.excited)) return false;
    const Row row{rail, waves.excited, BayFactors(waves.factor), law.change_from(uniform_pad_stiffness_n_per_m),
                  waves.settled + (-1.0)};
    Sides behind_of, ahead_of;
    sweep(row, work.strength, behind_of, ahead_of);
    const std::array<BayPoint, kMostPoints> points = bay_points(rail.placed, waves);
    const WavePair over{waves.factor[0] / waves.excited[0], waves.factor[1] / waves.excited[1]};
    const std::vector<std::size_t>& order = rail.placed.order;
    std::array<WavePair, kMostPoints> beta;  // of the points met, from the foremost
    const std::size_t count = order.size();
    for (std::size_t p = count; p-- > 0;) {
        const std::size_t met = count - 1 - p;
        for (std::size_t k = 0; k < met; ++k) {
            const WavePair behind{beta[k][0] * row.bay.first, beta[k][1] * row.bay.second};
            const WavePair ahead{beta[k][0] * waves.excited[0], beta[k][1] * waves.excited[1]};
            const std::size_t a = order[count - 1 - k], b = order[p];
            result.between[a * count + b] = result.between[b * count + a] =
                dot(points[p].from_front, ahead) + dot(points[p].from_rear, times(behind_of[p], behind));
            beta[k] = behind;
        }
        const Driven driven = drive(points[p], over, behind_of[p], ahead_of[p], waves.settled);
        beta[met] = driven.backward;
        result.between[order[p] * count + order[p]] = driven.own;
        result.trackbed[order[p]] = driven.settled;
        if (p > 0)
            travel_back(row.bay, work.strength, rail.placed.points[p].seat, rail.placed.points[p - 1].seat + 1, met + 1,
                        beta);
    }
    return true;
}

}  // namespace railpem::track

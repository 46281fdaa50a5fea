#include "track/rail/bloch_waves.hpp"

#include <algorithm>

namespace railpem::track {

using lanes::Complex;
using lanes::Matrix2;
using lanes::Vector2;

namespace {

/// Of 1 − λ₁/λ₂ and of the rotation times the bay: so far from zero, and so far from infinity, 1e-16 stays below 1e-10.
constexpr double kApart = 1e-3;

Complex row_times(const Complex& a, const Complex& b, const Complex& rotation) {
    return a + b * rotation;
}

}  // namespace

BlochWaves bloch_waves(const TrackParameters& track, double pad_stiffness_n_per_m, lanes::Real omega,
                       const SupportLaw& law, const TrackModifiers& modifiers) {
    return bloch_waves(uniform_rail(track, {0.0}, pad_stiffness_n_per_m, modifiers), omega, law);
}

BlochWaves bloch_waves(const ExactRail& rail, lanes::Real omega, const SupportLaw& law) {
    BlochWaves waves;
    waves.spacing_m = rail.spacing_m;
    waves.beam = beam_coefficients(rail.rail, rail.dampers, omega, rail.modifiers.rail);
    waves.support = law.stiffness(rail.uniform_pad_stiffness_n_per_m);
    const RailElement bay = rail_element(waves.beam, rail.spacing_m);
    const HalfTrack half = uniform_half_track(rail, omega, bay, waves.support);
    waves.factor = {half.factor_1, half.factor_2};
    const Complex turning = lanes::reciprocal(half.advance.b);
    for (std::size_t i = 0; i < 2; ++i) waves.rotation[i] = (waves.factor[i] - half.advance.a) * turning;
    // A force over a pad turns nothing there: the deflection is 1/(2a + K), and over the next pad the advance of that.
    const Complex share = lanes::reciprocal((half.stiffness.a * 2.0 + waves.support) * (half.factor_1 - half.factor_2));
    waves.excited = {share * (half.advance.a - half.factor_2), share * (half.factor_1 - half.advance.a)};
    waves.settled = waves.support / ((bay.near.a + bay.far.a) * 2.0 + waves.support);
    return waves;
}

bool apart(const BlochWaves& waves) {
    using lanes::norm;
    const lanes::Real difference = norm(waves.factor[0] - waves.factor[1]), first = norm(waves.factor[0]),
                      second = norm(waves.factor[1]);
    const lanes::Real turned = norm(waves.rotation[0]), other_turned = norm(waves.rotation[1]);
    constexpr double apart2 = kApart * kApart;
    const double turned2 = 1.0 / (apart2 * waves.spacing_m * waves.spacing_m);
    for (int lane = 0; lane < lanes::width; ++lane)
        if (!(difference[lane] > apart2 * std::max(first[lane], second[lane]) &&
              std::max(turned[lane], other_turned[lane]) < turned2))
            return false;
    return true;
}

BayPoint bay_point(const BlochWaves& waves, double ahead_m) {
    BayPoint point;
    if (ahead_m == 0.0) {
        point.from_rear = {Complex(1.0), Complex(1.0)};
        point.from_front = waves.factor;
        point.own = waves.excited[0] + waves.excited[1];
        point.lifted = Complex(1.0);
        return point;
    }
    const RailElement behind = rail_element(waves.beam, ahead_m),
                      ahead = rail_element(waves.beam, waves.spacing_m - ahead_m);
    // receptance between pads that do not move
    const Matrix2 clamped = lanes::inverse(mirrored(behind.near) + ahead.near);
    const Matrix2 rear = Matrix2{} - clamped * transpose(behind.far), front = Matrix2{} - clamped * ahead.far;
    point.own = clamped.a;
    point.lifted = rear.a + front.a;
    for (std::size_t i = 0; i < 2; ++i) {
        const Complex& rotation = waves.rotation[i];
        const Complex rear_ahead = row_times(rear.a, rear.b, rotation),
                      front_ahead = row_times(front.a, front.b, rotation);
        const Complex rear_back = row_times(rear.a, rear.b, -rotation),
                      front_back = row_times(front.a, front.b, -rotation);
        point.from_rear[i] = rear_ahead + waves.factor[i] * front_ahead;
        point.from_front[i] = front_back + waves.factor[i] * rear_back;
        // The pads move with the waves that the point's own force sends out.
        point.own += waves.excited[i] * (point.from_rear[i] * rear_back + point.from_front[i] * front_ahead);
    }
    return point;
}

}  // namespace railpem::track

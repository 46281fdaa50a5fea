#include "track/bloch_waves.hpp"

#include <cmath>

namespace railpem::track {

using lanes::Complex;
using lanes::Matrix2;
using lanes::Vector2;

namespace {

/// Of 1 − λ₁/λ₂ and of the rotation times the bay: so far from zero, and so far from infinity, 1e-16 stays below 1e-10.
constexpr double kApart = 1e-3;

Complex row_times(const Complex& a, const Complex& b, const Complex& rotation) { return a + b * rotation; }

}  // namespace

BlochWaves bloch_waves(const TrackParameters& track, double pad_stiffness_n_per_m, lanes::Real omega, const SupportLaw& law) {
    BlochWaves waves;
    waves.spacing_m = track.spacing_m;
    waves.beam = beam_coefficients(track.rail, track.rail_dampers, omega);
    waves.support = law.stiffness(pad_stiffness_n_per_m);
    const HalfTrack half = uniform_half_track(uniform_rail(track, {0.0}, pad_stiffness_n_per_m), omega);
    waves.factor = {half.factor_1, half.factor_2};
    const Complex turning = lanes::reciprocal(half.advance.b);
    for (std::size_t i = 0; i < 2; ++i) waves.rotation[i] = (waves.factor[i] - half.advance.a) * turning;
    // A force over a pad turns nothing there: the deflection is 1/(2a + K), and over the next pad the advance of that.
    const Complex share = lanes::reciprocal((half.stiffness.a * 2.0 + waves.support) * (half.factor_1 - half.factor_2));
    waves.excited = {share * (half.advance.a - half.factor_2), share * (half.factor_1 - half.advance.a)};
    return waves;
}

bool apart(const BlochWaves& waves) {
    for (int lane = 0; lane < lanes::width; ++lane) {
        const double difference = std::abs(waves.factor[0][lane] - waves.factor[1][lane]);
        const double larger = std::max(std::abs(waves.factor[0][lane]), std::abs(waves.factor[1][lane]));
        const double turned = std::max(std::abs(waves.rotation[0][lane]), std::abs(waves.rotation[1][lane])) * waves.spacing_m;
        if (!(difference > kApart * larger && turned < 1.0 / kApart)) return false;
    }
    return true;
}

BayPoint bay_point(const BlochWaves& waves, double ahead_m) {
    BayPoint point;
    if (ahead_m == 0.0) {
        point.from_rear = {Complex(1.0), Complex(1.0)};
        point.from_front = waves.factor;
        point.own = waves.excited[0] + waves.excited[1];
        return point;
    }
    const RailElement behind = rail_element(waves.beam, ahead_m), ahead = rail_element(waves.beam, waves.spacing_m - ahead_m);
    const Matrix2 clamped = lanes::inverse(mirrored(behind.near) + ahead.near);  // receptance between pads that do not move
    const Matrix2 rear = Matrix2{} - clamped * transpose(behind.far), front = Matrix2{} - clamped * ahead.far;
    point.own = clamped.a;
    for (std::size_t i = 0; i < 2; ++i) {
        const Complex& rotation = waves.rotation[i];
        const Complex rear_ahead = row_times(rear.a, rear.b, rotation), front_ahead = row_times(front.a, front.b, rotation);
        const Complex rear_back = row_times(rear.a, rear.b, -rotation), front_back = row_times(front.a, front.b, -rotation);
        point.from_rear[i] = rear_ahead + waves.factor[i] * front_ahead;
        point.from_front[i] = front_back + waves.factor[i] * rear_back;
        // The pads move with the waves that the point's own force sends out.
        point.own += waves.excited[i] * (point.from_rear[i] * rear_back + point.from_front[i] * front_ahead);
    }
    return point;
}

}  // namespace railpem::track

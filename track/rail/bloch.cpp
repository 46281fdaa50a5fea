#include "track/rail/bloch.hpp"

#include <cmath>
#include <complex>

namespace railpem::track {

using lanes::Complex;
using lanes::Matrix2;
using lanes::Real;

namespace {

/// Below this distance of |λ| from 1 the size does not tell the direction any more; rounding in C is about 1e-15, and
/// λ is its square root at the edge of a stop band.
constexpr double kUndecided = 1e-7;

struct Cosines {
    Complex first, second;
};

/// Roots of C²(4cf + 4d²) + C(2f·m1 + 2c·m2) + m1·m2 − 4d² = 0 with far = [c d; −d f], M = diag(m1, m2).
Cosines bloch_cosines(const RailElement& bay, const Complex& support) {
    const Complex& c = bay.far.a;
    const Complex& d = bay.far.b;
    const Complex& f = bay.far.d;
    const Complex m1 = bay.near.a * 2.0 + support;
    const Complex m2 = bay.near.d * 2.0;
    const Complex d2 = d * d * 4.0;
    const Complex quadratic = c * f * 4.0 + d2;
    const Complex linear = f * m1 + c * m2;  // half of the coefficient of C
    const Complex constant = m1 * m2 - d2;
    Complex root = lanes::sqrt(linear * linear - quadratic * constant);
    // The sign that adds, so that the larger root has no cancellation.
    for (int lane = 0; lane < lanes::width; ++lane)
        if (linear.re[lane] * root.re[lane] + linear.im[lane] * root.im[lane] < 0.0) root.set(lane, -root[lane]);
    const Complex larger = -(linear + root);
    return {larger / quadratic, constant / larger};
}

Complex decaying_factor(const Complex& cosine) {
    const Complex root = lanes::sqrt((cosine + (-1.0)) * (cosine + 1.0));
    Complex growing = cosine + root;
    const Complex other = cosine - root;
    for (int lane = 0; lane < lanes::width; ++lane)
        if (std::norm(growing[lane]) < std::norm(other[lane])) growing.set(lane, other[lane]);
    return lanes::reciprocal(growing);
}

bool undecided(const Complex& factor) {
    for (int lane = 0; lane < lanes::width; ++lane)
        if (std::abs(1.0 - std::norm(factor[lane])) < kUndecided) return true;
    return false;
}

/// Of λ and 1/λ the one nearer to the decaying factor of the lossy track.
void decide(Complex& factor, const Complex& lossy) {
    for (int lane = 0; lane < lanes::width; ++lane) {
        const std::complex<double> one = factor[lane], other = 1.0 / one;
        if (std::abs(1.0 - std::norm(one)) < kUndecided && std::abs(other - lossy[lane]) < std::abs(one - lossy[lane]))
            factor.set(lane, other);
    }
}

}  // namespace

HalfTrack half_track(const RailElement& bay, const Complex& support, const std::function<Bay()>& lossy) {
    HalfTrack track;
    const Cosines cosines = bloch_cosines(bay, support);
    track.factor_1 = decaying_factor(cosines.first);
    track.factor_2 = decaying_factor(cosines.second);
    if (undecided(track.factor_1) || undecided(track.factor_2)) {
        const Bay lossier = lossy();
        const Cosines split = bloch_cosines(lossier.first, lossier.second);
        decide(track.factor_1, decaying_factor(split.first));
        decide(track.factor_2, decaying_factor(split.second));
    }
    // farᵀ + M·X + far·X² = 0 with X² = tX − d: (M + t·far)·X = d·far − farᵀ.
    const Complex sum = track.factor_1 + track.factor_2;
    const Complex product = track.factor_1 * track.factor_2;
    Matrix2 left = bay.far * sum;
    left.a += bay.near.a * 2.0 + support;
    left.d += bay.near.d * 2.0;
    track.advance = lanes::inverse(left) * (bay.far * product - transpose(bay.far));
    track.stiffness = bay.near + bay.far * track.advance;
    return track;
}

}  // namespace railpem::track

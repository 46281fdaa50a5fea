#include "track/elements/rail_element.hpp"

#include <algorithm>
#include <cmath>

#include "lanes/elementary_lanes.hpp"

namespace railpem::track {

using lanes::Complex;
using lanes::Matrix2;
using lanes::Real;

namespace {

constexpr double kSlowest_rad_per_s = 1e-6;  ///< below it losses that follow the frequency are none
constexpr double kSeriesReach = 2.0;         ///< largest |λℓ| summed directly
/// (2·kSeriesReach)^28/28! < 1e-12 of the leading term even where p and q both count
constexpr int kSeriesTerms = 14;

/// Entire functions C0…C3 of exp(Aℓ), each divided by its power of ℓ.
struct SeriesSums {
    Complex c0, c1, c2, c3;
};

/// A^{2m} = e_m + g_m A², A^{2m+1} = e_m A + g_m A³ with e_{m+1} = q·g_m, g_{m+1} = e_m + p·g_m (lengths scaled out).
SeriesSums sum_series(const Complex& p, const Complex& q) {
    SeriesSums sums{Complex(1.0), Complex(1.0), Complex(0.0), Complex(0.0)};
    Complex e(1.0), g(0.0);
    double even = 1.0, odd = 1.0;  // 1/(2m)!, 1/(2m+1)!
    for (int m = 1; m <= kSeriesTerms; ++m) {
        const Complex next = e + p * g;
        e = q * g;
        g = next;
        even /= (2.0 * m - 1.0) * (2.0 * m);
        odd /= (2.0 * m) * (2.0 * m + 1.0);
        sums.c0 += e * even;
        sums.c1 += e * odd;
        sums.c2 += g * even;
        sums.c3 += g * odd;
    }
    return sums;
}

RailElement short_element(const BeamCoefficients& beam, double length) {
    const Complex flexibility = lanes::reciprocal(beam.bending);  // 1/B
    const Complex& s = beam.shear_compliance;
    const Complex rotary_ratio = flexibility * beam.rotary;  // r/B
    const Complex shear_inertia = s * beam.inertia;          // sμ
    const Complex p = -(rotary_ratio + shear_inertia);
    const Complex q = beam.inertia * flexibility * (Complex(1.0) - s * beam.rotary);
    const double l2 = length * length;
    SeriesSums c = sum_series(p * l2, q * (l2 * l2));
    c.c1 = c.c1 * length;
    c.c2 = c.c2 * l2;
    c.c3 = c.c3 * (l2 * length);

    // Blocks of exp(Aℓ): end displacements from start displacements (w, ψ) and from start forces (Q, M).
    const Matrix2 from_displacement{c.c0 - c.c2 * shear_inertia, c.c1 + c.c3 * p, c.c3 * beam.inertia * flexibility,
                                    c.c0 - c.c2 * rotary_ratio};
    const Complex moment = c.c2 * flexibility;
    const Matrix2 from_force{c.c1 * s - c.c3 * (s * shear_inertia + flexibility), moment, -moment,
                             (c.c1 - c.c3 * rotary_ratio) * flexibility};
    const Matrix2 inverted = lanes::inverse(from_force);
    const Matrix2 zero{};
    return {inverted * from_displacement, zero - inverted};
}

/// Of any lane; a bound from the sizes of p and q, λ⁴ = pλ² + q.
double largest_wavenumber(const BeamCoefficients& beam) {
    const Complex flexibility = lanes::reciprocal(beam.bending);
    const Complex& s = beam.shear_compliance;
    const Real p2 = lanes::norm(flexibility * beam.rotary + s * beam.inertia);
    const Real q2 = lanes::norm(beam.inertia * flexibility * (Complex(1.0) - s * beam.rotary));
    const Real square = 0.5 * lanes::sqrt(p2) + lanes::sqrt(0.25 * p2 + lanes::sqrt(q2));
    double largest = 0.0;
    for (int lane = 0; lane < lanes::width; ++lane) largest = std::max(largest, square[lane]);
    return std::sqrt(largest);
}

/// Two equal elements in a row, the node between them condensed.
RailElement doubled(const RailElement& half) {
    // near + mirrored(near) is diagonal.
    const Complex across = lanes::reciprocal(half.near.a * 2.0);
    const Complex turning = lanes::reciprocal(half.near.d * 2.0);
    const Matrix2& f = half.far;
    const Matrix2 weighted{f.a * across, f.b * turning, f.c * across, f.d * turning};
    const Matrix2 zero{};
    return {half.near - weighted * transpose(f), zero - weighted * f};
}

}  // namespace

BeamCoefficients beam_coefficients(const RailParameters& rail, const std::vector<RailDamper>& dampers, Real omega,
                                   const lanes::FactorCurve& mass_factor) {
    Complex loss(std::complex<double>(1.0, rail.loss_factor));
    if (rail.loss_reference_hz > 0.0) loss.im = omega * (rail.loss_factor / (2.0 * M_PI * rail.loss_reference_hz));
    const Real omega2 = omega * omega;
    BeamCoefficients beam;
    beam.bending = loss * (rail.youngs_modulus_pa * rail.second_moment_of_area_m4);
    beam.rotary = Real{};
    beam.inertia = Complex(omega2 * rail.mass_kg_per_m, Real{});
    if (rail.beam == Beam::timoshenko) {
        beam.shear_compliance =
            lanes::reciprocal(loss * (rail.shear_coefficient * rail.shear_modulus_pa * rail.cross_section_m2));
        beam.rotary = omega2 * (rail.mass_kg_per_m * rail.second_moment_of_area_m4 / rail.cross_section_m2);
    }
    for (const RailDamper& damper : dampers) {
        const double natural = 2.0 * M_PI * damper.frequency_hz;
        const Real slowest = lanes::broadcast(kSlowest_rad_per_s), positive = omega > slowest ? omega : slowest;
        const Real own_loss = lanes::power(positive * (1.0 / natural), damper.loss_exponent) * damper.loss_factor;
        const Complex spring(lanes::broadcast(natural * natural), natural * natural * own_loss);
        beam.inertia += spring * lanes::reciprocal(spring + (-omega2)) * (damper.mass_kg_per_m * omega2);
    }
    if (!mass_factor.empty()) beam.inertia = beam.inertia * mass_factor.at(omega);
    return beam;
}

Complex beam_stiffness(const BeamCoefficients& beam, Real wavenumber_per_m) {
    const Real k2 = wavenumber_per_m * wavenumber_per_m;
    const Complex turning = beam.bending * k2 + (-beam.rotary);
    return turning * k2 / (beam.shear_compliance * turning + 1.0) - beam.inertia;
}

Matrix2 mirrored(const Matrix2& block) {
    return {block.a, -block.b, -block.c, block.d};
}

RailElement rail_element(const BeamCoefficients& beam, double length_m) {
    const double wavenumber = largest_wavenumber(beam);
    int doublings = 0;
    while (wavenumber * length_m > kSeriesReach) {
        length_m /= 2.0;
        ++doublings;
    }
    RailElement element = short_element(beam, length_m);
    for (int i = 0; i < doublings; ++i) element = doubled(element);
    return element;
}

}  // namespace railpem::track

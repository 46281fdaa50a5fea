#pragma once

#include <complex>

namespace railpem::simulate {

using Complex = std::complex<double>;

/// a·b without the NaN branch of the library's operator: the hot loops are made of this.
inline Complex product(Complex a, Complex b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// One step of the two-stage Radau IIA method (order 3, L-stable, stiffly accurate; Hairer & Wanner, Solving Ordinary
/// Differential Equations II, section IV.5), with the Butcher matrix A diagonalised so that a step costs one complex
/// solve.
///
/// A·(t1, t2)ᵀ = λ·(t1, t2)ᵀ with t2 = 1/2. The values X1, X2 of any quantity at the two stages (at 1/3 of the step and
/// at its end) travel as one complex number X̂ = τ1·X1 + τ2·X2; back: X_i = 2·Re(t_i·X̂), so that X2 = Re X̂. In this form
/// the derivative of a quantity with value x at the start of the step is multiplication: X̂' = s·(X̂ − 1̂·x), s =
/// 1/(λ·step). Every linear law therefore enters with its Laplace transform at the one complex frequency s.
struct RadauStep {
    explicit RadauStep(double step);

    double step_s;
    Complex s;    ///< 1/s
    Complex one;  ///< 1̂ = τ1 + τ2, the transform of a constant
    Complex t1;   ///< t2 is 1/2
    Complex tau1, tau2;
    static constexpr double first_stage = 1.0 / 3.0;

    Complex transform(double stage1, double stage2) const { return tau1 * stage1 + tau2 * stage2; }
    double at_first(Complex value) const { return 2.0 * (t1.real() * value.real() - t1.imag() * value.imag()); }
    static double at_end(Complex value) { return value.real(); }
    Complex derivative(Complex value, double at_start) const { return product(s, value - one * at_start); }
};

}  // namespace railpem::simulate

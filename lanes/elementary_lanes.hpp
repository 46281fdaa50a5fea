#pragma once
// Powers and circular functions of all lanes at once. The library's functions take one number at a time, which costs
// more than everything else in a sum over many wavenumbers.

#include <bit>

#include "lanes/complex_lanes.hpp"

namespace railpem::lanes {

/// Bits of one real number per lane.
using Bits = long long __attribute__((vector_size(width * sizeof(long long))));

/// 1.5·2^52: adding it rounds to an integer and leaves that integer in the lowest bits.
inline constexpr double kRounding = 6755399441055744.0;

/// Natural logarithm; x > 0, finite and not denormal. Error below 1e-15·max(1, |log x|).
inline Real log(Real x) {
    // x = 2^e·m with m in [√½, √2): log m = 2·artanh s, s = (m − 1)/(m + 1), |s| < 0.172; s^19 is below 3e-15·s.
    // exponent of x/√½, in place
    const Bits above = (std::bit_cast<Bits>(x) - 0x3fe6a09e667f3bcdLL) & ~((1LL << 52) - 1);
    const Real m = std::bit_cast<Real>(std::bit_cast<Bits>(x) - above);
    const Real e = std::bit_cast<Real>((above >> 52) + std::bit_cast<Bits>(broadcast(kRounding))) - kRounding;
    const Real s = (m - 1.0) / (m + 1.0), s2 = s * s;
    Real sum = broadcast(1.0 / 19.0);
    for (int n = 17; n >= 1; n -= 2) sum = sum * s2 + 1.0 / n;
    return e * 0.693147180559945309 + 2.0 * s * sum;
}

/// e^x for |x| < 700, relative error below 1e-15·max(1, |x|).
inline Real exp(Real x) {
    const Real rounded = x * 1.44269504088896341 + kRounding;
    const Real n = rounded - kRounding;
    // ln 2 in two parts (Cody & Waite 1980)
    const Real r = (x - n * 0.693147180369123816) - n * 1.90821492927058770e-10;
    Real sum = broadcast(1.0);
    for (int k = 13; k >= 1; --k) sum = sum * r * (1.0 / k) + 1.0;  // |r| < 0.347: r^14/14! < 1e-17
    // the integer goes onto the exponent
    return std::bit_cast<Real>((std::bit_cast<Bits>(rounded) << 52) + std::bit_cast<Bits>(sum));
}

/// x^exponent for x > 0; exactly 1 for a zero exponent.
inline Real power(Real x, double exponent) {
    return exponent == 0.0 ? broadcast(1.0) : exp(log(x) * exponent);
}

/// e^{ix} for |x| < 1e5; absolute error below 1e-15·max(1, |x|).
inline Complex unit(Real x) {
    const Real rounded = x * 0.636619772367581343 + kRounding;
    const Real n = rounded - kRounding;
    // π/2 in two parts, the first of 33 bits
    const Real r = (x - n * 1.57079632673412561) - n * 6.07710050650619224e-11;
    const Real r2 = r * r;
    Real sine = broadcast(1.0), cosine = broadcast(1.0);  // |r| < 0.786: r^18/18! < 3e-18
    for (int k = 8; k >= 1; --k) {
        sine = 1.0 - sine * r2 * (1.0 / (2 * k * (2 * k + 1)));
        cosine = 1.0 - cosine * r2 * (1.0 / (2 * k * (2 * k - 1)));
    }
    sine = sine * r;
    const Bits quadrant = std::bit_cast<Bits>(rounded);
    const Bits swapped = (quadrant & 1) != 0, flip_sine = (quadrant & 2) != 0, flip_cosine = ((quadrant + 1) & 2) != 0;
    const Real s = swapped ? cosine : sine, c = swapped ? sine : cosine;
    return {flip_cosine ? -c : c, flip_sine ? -s : s};
}

}  // namespace railpem::lanes

#pragma once
// Frequency lines side by side: one complex number per lane, so that the same arithmetic solves several lines at once.
// Every line does the same operations in the same order wherever it stands, so results do not depend on how lines are
// handed to threads.

#include <array>
#include <cmath>
#include <complex>

namespace railpem::lanes {

// One register full, which profiled best where they have 256 bits; two where they have 128.
#ifdef __AVX512F__
inline constexpr int width = 8;
#else
inline constexpr int width = 4;
#endif

/// One real number per lane.
using Real = double __attribute__((vector_size(width * sizeof(double))));

inline Real broadcast(double value) {
    return Real{} + value;
}

inline Real sqrt(Real x) {
    Real result;
    for (int lane = 0; lane < width; ++lane) result[lane] = std::sqrt(x[lane]);
    return result;
}

/// One complex number per lane.
struct Complex {
    Real re{};
    Real im{};

    Complex() = default;
    Complex(Real real, Real imaginary) : re(real), im(imaginary) {}
    explicit Complex(double real) : re(broadcast(real)) {}
    explicit Complex(std::complex<double> value) : re(broadcast(value.real())), im(broadcast(value.imag())) {}

    std::complex<double> operator[](int lane) const { return {re[lane], im[lane]}; }
    void set(int lane, std::complex<double> value) {
        re[lane] = value.real();
        im[lane] = value.imag();
    }
    Complex& operator+=(const Complex& b) {
        re += b.re;
        im += b.im;
        return *this;
    }
    Complex& operator-=(const Complex& b) {
        re -= b.re;
        im -= b.im;
        return *this;
    }
};

inline Complex operator+(const Complex& a, const Complex& b) {
    return {a.re + b.re, a.im + b.im};
}
inline Complex operator-(const Complex& a, const Complex& b) {
    return {a.re - b.re, a.im - b.im};
}
inline Complex operator-(const Complex& a) {
    return {-a.re, -a.im};
}
inline Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Complex operator*(const Complex& a, Real b) {
    return {a.re * b, a.im * b};
}
inline Complex operator*(const Complex& a, double b) {
    return {a.re * b, a.im * b};
}
inline Complex operator+(const Complex& a, Real b) {
    return {a.re + b, a.im};
}
inline Complex operator+(const Complex& a, double b) {
    return {a.re + b, a.im};
}

inline Real norm(const Complex& a) {
    return a.re * a.re + a.im * a.im;
}
inline Complex reciprocal(const Complex& a) {
    const Real scale = 1.0 / norm(a);
    return {a.re * scale, -a.im * scale};
}
inline Complex operator/(const Complex& a, const Complex& b) {
    return a * reciprocal(b);
}

/// i·x·a
inline Complex times_i(const Complex& a, Real x) {
    return {-a.im * x, a.re * x};
}

/// Principal square root (real part ≥ 0), lane by lane.
inline Complex sqrt(const Complex& a) {
    Complex result;
    for (int lane = 0; lane < width; ++lane) result.set(lane, std::sqrt(a[lane]));
    return result;
}

/// size·e^{i·angle}, lane by lane.
inline Complex polar(Real size, Real angle) {
    Real re = size, im = size;
    for (int lane = 0; lane < width; ++lane) {
        re[lane] *= std::cos(angle[lane]);
        im[lane] *= std::sin(angle[lane]);
    }
    return {re, im};
}

/// A 2×2 block per lane.
struct Matrix2 {
    Complex a, b, c, d;  ///< [a b; c d]
};

inline Matrix2 operator+(const Matrix2& x, const Matrix2& y) {
    return {x.a + y.a, x.b + y.b, x.c + y.c, x.d + y.d};
}
inline Matrix2 operator-(const Matrix2& x, const Matrix2& y) {
    return {x.a - y.a, x.b - y.b, x.c - y.c, x.d - y.d};
}
inline Matrix2 operator*(const Matrix2& x, const Matrix2& y) {
    return {x.a * y.a + x.b * y.c, x.a * y.b + x.b * y.d, x.c * y.a + x.d * y.c, x.c * y.b + x.d * y.d};
}
inline Matrix2 operator*(const Matrix2& x, const Complex& s) {
    return {x.a * s, x.b * s, x.c * s, x.d * s};
}
inline Matrix2 transpose(const Matrix2& x) {
    return {x.a, x.c, x.b, x.d};
}
inline Matrix2 inverse(const Matrix2& x) {
    const Complex scale = reciprocal(x.a * x.d - x.b * x.c);
    return {x.d * scale, -(x.b * scale), -(x.c * scale), x.a * scale};
}

struct Vector2 {
    Complex a, b;
};
inline Vector2 operator+(const Vector2& x, const Vector2& y) {
    return {x.a + y.a, x.b + y.b};
}
inline Vector2 operator-(const Vector2& x, const Vector2& y) {
    return {x.a - y.a, x.b - y.b};
}
inline Vector2 operator*(const Matrix2& m, const Vector2& v) {
    return {m.a * v.a + m.b * v.b, m.c * v.a + m.d * v.b};
}

}  // namespace railpem::lanes

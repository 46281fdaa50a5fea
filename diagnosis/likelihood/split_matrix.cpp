#include "diagnosis/likelihood/split_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace railpem::diagnosis {

namespace {

/// of numbers that are multiplied before their logarithm is taken: two of them stay far from underflow
constexpr double kLeastProduct = 1e-100;

/// y += (a + ib)·x, all `Rows` at once: single rows that a triangle does not have are zero and cost less than asking.
template <std::size_t Rows>
inline void add_all(double a, double b, const double* __restrict x_re, const double* __restrict x_im,
                    double* __restrict y_re, double* __restrict y_im) {
#pragma omp simd
    for (std::size_t i = 0; i < Rows; ++i) {
        y_re[i] += a * x_re[i] - b * x_im[i];
        y_im[i] += a * x_im[i] + b * x_re[i];
    }
}

/// The same where the rows before `first` are not asked for, or those of x are zero: a triangle has two thirds of the
/// vectors.
template <std::size_t Rows>
inline void add(std::size_t first, double a, double b, const double* x_re, const double* x_im, double* y_re,
                double* y_im) {
    if constexpr (Rows > kVector) {
        if (first < kVector)
            add_all<Rows>(a, b, x_re, x_im, y_re, y_im);
        else
            add<Rows - kVector>(first - kVector, a, b, x_re + kVector, x_im + kVector, y_re + kVector, y_im + kVector);
    } else {
        add_all<Rows>(a, b, x_re, x_im, y_re, y_im);
    }
}

/// Right-looking Cholesky: column k of `model` becomes L_k. 1/L_kk, and log det, NaN where the matrix is not definite.
template <std::size_t Rows>
double factorise(SplitMatrix& model, std::size_t given, double* reciprocal) {
    const std::size_t size = std::min(given, Rows);  // never less: for the compiler to know
    double log_determinant = 0.0, product = 1.0;     // of pivots: one logarithm serves all of them
    for (std::size_t k = 0; k < size; ++k) {
        const double pivot = model.re[k][k];
        if (!(pivot > 0.0) || !std::isfinite(pivot)) return std::numeric_limits<double>::quiet_NaN();
        if (!(product > kLeastProduct && product < 1.0 / kLeastProduct && pivot > kLeastProduct &&
              pivot < 1.0 / kLeastProduct))
            log_determinant += std::log(product), product = 1.0;
        product *= pivot;
        const double scale = reciprocal[k] = 1.0 / std::sqrt(pivot);
        for (std::size_t i = 0; i < Rows; ++i) {
            model.re[k][i] = i < k ? 0.0 : model.re[k][i] * scale;
            model.im[k][i] = i <= k ? 0.0 : model.im[k][i] * scale;
        }
        for (std::size_t j = k + 1; j < size; ++j)
            add<Rows>(j, -model.re[k][j], model.im[k][j], model.re[k], model.im[k], model.re[j], model.im[j]);
    }
    return log_determinant + std::log(product);
}

template <std::size_t Rows>
double invert_rows(SplitMatrix& model, std::size_t given, SplitMatrix& inverse) {
    const std::size_t size = std::min(given, Rows);
    double reciprocal[kMostChannels];
    const double log_determinant = factorise<Rows>(model, size, reciprocal);
    if (std::isnan(log_determinant)) return log_determinant;
    for (std::size_t c = 0; c < size; ++c) {  // L v = e_c
        double *re = inverse.re[c], *im = inverse.im[c];
        for (std::size_t i = 0; i < Rows; ++i) re[i] = i == c ? 1.0 : 0.0, im[i] = 0.0;
        for (std::size_t k = c; k < size; ++k) {
            const double a = re[k] * reciprocal[k], b = im[k] * reciprocal[k];
            add<Rows>(k, -a, -b, model.re[k], model.im[k], re, im);
            re[k] = a;
            im[k] = b;
        }
    }
    return log_determinant;
}

/// result_j += Σ_{k ≤ j} half_k conj(inverse_jk), the rows of the lower triangle.
template <std::size_t Rows>
void close(const SplitMatrix& half, const SplitMatrix& inverse, std::size_t size, SplitMatrix& result) {
    for (std::size_t j = 0; j < size; ++j) {
        for (std::size_t i = 0; i < Rows; ++i) result.re[j][i] = result.im[j][i] = 0.0;
        for (std::size_t k = 0; k <= j; ++k)
            add<Rows>(j, inverse.re[k][j], -inverse.im[k][j], half.re[k], half.im[k], result.re[j], result.im[j]);
    }
}

template <std::size_t Rows>
void sandwich_rows(const SplitMatrix& inverse, const SplitMatrix& hermitian, std::size_t size, SplitMatrix& result) {
    SplitMatrix half;
    for (std::size_t k = 0; k < size; ++k) {
        for (std::size_t i = 0; i < Rows; ++i) half.re[k][i] = half.im[k][i] = 0.0;
        for (std::size_t m = 0; m < size; ++m)
            add<Rows>(m, hermitian.re[k][m], hermitian.im[k][m], inverse.re[m], inverse.im[m], half.re[k], half.im[k]);
    }
    close<Rows>(half, inverse, size, result);
}

template <std::size_t Rows>
void sandwich_diagonal_rows(const SplitMatrix& inverse, const double* diagonal, std::size_t size, SplitMatrix& result) {
    SplitMatrix half;
    for (std::size_t k = 0; k < size; ++k)
        for (std::size_t i = 0; i < Rows; ++i)
            half.re[k][i] = diagonal[k] * inverse.re[k][i], half.im[k][i] = diagonal[k] * inverse.im[k][i];
    close<Rows>(half, inverse, size, result);
}

/// Calls `kernel` for the rows that `size` needs.
template <class Kernel>
auto for_rows(std::size_t size, const Kernel& kernel) {
    static_assert(kMostChannels == 16);
    switch (padded_rows(size)) {
        case 4:
            return kernel.template operator()<4>();
        case 8:
            return kernel.template operator()<8>();
        case 12:
            return kernel.template operator()<12>();
        default:
            return kernel.template operator()<16>();
    }
}

}  // namespace

void set_zero(SplitMatrix& matrix, std::size_t size) {
    for (std::size_t j = 0; j < size; ++j)
        for (std::size_t i = 0; i < padded_rows(size); ++i) matrix.re[j][i] = matrix.im[j][i] = 0.0;
}

double invert_factor(SplitMatrix& model, std::size_t size, SplitMatrix& inverse) {
    return for_rows(size, [&]<std::size_t Rows> { return invert_rows<Rows>(model, size, inverse); });
}

double log_determinant(SplitMatrix& model, std::size_t size) {
    double unused[kMostChannels];
    return for_rows(size, [&]<std::size_t Rows> { return factorise<Rows>(model, size, unused); });
}

void sandwich(const SplitMatrix& inverse, const SplitMatrix& hermitian, std::size_t size, SplitMatrix& result) {
    for_rows(size, [&]<std::size_t Rows> { sandwich_rows<Rows>(inverse, hermitian, size, result); });
}

void sandwich_diagonal(const SplitMatrix& inverse, const double* diagonal, std::size_t size, SplitMatrix& result) {
    for_rows(size, [&]<std::size_t Rows> { sandwich_diagonal_rows<Rows>(inverse, diagonal, size, result); });
}

double trace_of_product(const SplitMatrix& a, const SplitMatrix& b, std::size_t size) {
    double diagonal = 0.0, below = 0.0;
    for (std::size_t j = 0; j < size; ++j) {
        diagonal += a.re[j][j] * b.re[j][j];
        for (std::size_t i = j + 1; i < size; ++i) below += a.re[j][i] * b.re[j][i] + a.im[j][i] * b.im[j][i];
    }
    return diagonal + 2.0 * below;
}

}  // namespace railpem::diagnosis

#pragma once
// Matrices of one bin, real and imaginary parts apart: what the compiler turns into vector instructions without
// shuffling.

#include <cstddef>

#include "diagnosis/observations/observation.hpp"

namespace railpem::diagnosis {

/// A complex matrix of at most kMostChannels columns; rows beyond `size` are zero up to the next multiple of four.
struct SplitMatrix {
    alignas(64) double re[kMostChannels][kMostChannels];  ///< [column][row]
    alignas(64) double im[kMostChannels][kMostChannels];
};

inline constexpr std::size_t kVector = 4;  ///< rows that a kernel takes at once

/// Rows that a kernel works on: `size` rounded up to full vectors.
inline std::size_t padded_rows(std::size_t size) {
    return (size + kVector - 1) / kVector * kVector;
}

void set_zero(SplitMatrix& matrix, std::size_t size);

/// L⁻¹ of the Hermitian positive definite `model` = LLᴴ, whose lower triangle is read and overwritten. Returns log det,
/// or NaN where the matrix is not definite. Above the diagonal `inverse` is zero.
double invert_factor(SplitMatrix& model, std::size_t size, SplitMatrix& inverse);

/// log det alone.
double log_determinant(SplitMatrix& model, std::size_t size);

/// L⁻¹HL⁻ᴴ of a Hermitian H given in full; only the lower triangle of `result` is meant.
void sandwich(const SplitMatrix& inverse, const SplitMatrix& hermitian, std::size_t size, SplitMatrix& result);

/// L⁻¹·diag(d)·L⁻ᴴ, lower triangle.
void sandwich_diagonal(const SplitMatrix& inverse, const double* diagonal, std::size_t size, SplitMatrix& result);

/// tr(AB) of Hermitian matrices of which the lower triangles are given.
double trace_of_product(const SplitMatrix& a, const SplitMatrix& b, std::size_t size);

}  // namespace railpem::diagnosis

#include "track/elements/symmetric_band.hpp"

#include <algorithm>

namespace railpem::track {

using Eigen::Index;

namespace {

/// How many rows of the band below the diagonal exist in column i.
Index reach(const SymmetricBand& matrix, Index i) {
    return std::min<Index>(3, matrix.cols() - 1 - i);
}

}  // namespace

Eigen::VectorXd multiply(const SymmetricBand& matrix, const Eigen::VectorXd& x) {
    Eigen::VectorXd y = matrix.row(0).transpose().cwiseProduct(x);
    for (Index i = 0; i < matrix.cols(); ++i)
        for (Index k = 1; k <= reach(matrix, i); ++k) {
            y[i + k] += matrix(k, i) * x[i];
            y[i] += matrix(k, i) * x[i + k];
        }
    return y;
}

bool solve_in_place(SymmetricBand& matrix, Eigen::VectorXd& x) {
    for (Index i = 0; i < matrix.cols(); ++i) {
        const double pivot = matrix(0, i);
        if (!(pivot > 0.0)) return false;
        for (Index k = 1; k <= reach(matrix, i); ++k) {
            const double factor = matrix(k, i) / pivot;
            for (Index m = k; m <= reach(matrix, i); ++m) matrix(m - k, i + k) -= factor * matrix(m, i);
            x[i + k] -= factor * x[i];
        }
    }
    for (Index i = matrix.cols() - 1; i >= 0; --i) {
        for (Index k = 1; k <= reach(matrix, i); ++k) x[i] -= matrix(k, i) * x[i + k];
        x[i] /= matrix(0, i);
    }
    return true;
}

}  // namespace railpem::track

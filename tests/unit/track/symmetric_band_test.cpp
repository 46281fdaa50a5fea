#include "track/elements/symmetric_band.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace railpem::track {
namespace {

/// Entries without a pattern, diagonally dominant and so positive definite.
SymmetricBand some_band(Eigen::Index n) {
    SymmetricBand band(4, n);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 4; ++k) band(k, i) = k == 0 ? 7.0 + std::cos(3.0 * i) : std::sin(1.0 + 5.0 * i + 2.0 * k);
    return band;
}

Eigen::MatrixXd dense(const SymmetricBand& band) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(band.cols(), band.cols());
    for (Eigen::Index i = 0; i < band.cols(); ++i)
        for (Eigen::Index k = 0; k < 4 && i + k < band.cols(); ++k) matrix(i + k, i) = matrix(i, i + k) = band(k, i);
    return matrix;
}

TEST(SymmetricBand, MultipliesAndSolvesAsADenseMatrixDoes) {
    for (const Eigen::Index n : {1, 2, 3, 4, 5, 40}) {
        SymmetricBand band = some_band(n);
        const Eigen::MatrixXd full = dense(band);
        Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0);
        const Eigen::VectorXd expected = full.ldlt().solve(x);
        EXPECT_LE((multiply(band, x) - full * x).cwiseAbs().maxCoeff(), 1e-14 * 40.0);
        ASSERT_TRUE(solve_in_place(band, x));
        EXPECT_LE((x - expected).cwiseAbs().maxCoeff(), 1e-14);
    }
}

TEST(SymmetricBand, SaysWhenTheMatrixIsNotPositiveDefinite) {
    SymmetricBand band = some_band(6);
    band(0, 4) = -1.0;
    Eigen::VectorXd x = Eigen::VectorXd::Ones(6);
    EXPECT_FALSE(solve_in_place(band, x));
    SymmetricBand zero = SymmetricBand::Zero(4, 3);
    Eigen::VectorXd y = Eigen::VectorXd::Ones(3);
    EXPECT_FALSE(solve_in_place(zero, y));
}

}  // namespace
}  // namespace railpem::track

#include "diagnosis/likelihood/split_matrix.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <random>

namespace railpem::diagnosis {
namespace {

// Against Eigen, whose matrices are interleaved and not padded. Matrices are conditioned no worse than 1e4, rounding
// 1e-16: what is left is below 1e-11.
constexpr double kRounding = 1e-11;

class SplitMatrices : public testing::TestWithParam<int> {
  protected:
    Eigen::MatrixXcd hermitian() {
        const Eigen::MatrixXcd root = Eigen::MatrixXcd::NullaryExpr(
            GetParam(), GetParam(), [&] { return std::complex(normal_(random_), normal_(random_)); });
        return root * root.adjoint() + 0.1 * Eigen::MatrixXcd::Identity(GetParam(), GetParam());
    }
    static SplitMatrix split(const Eigen::MatrixXcd& matrix) {
        SplitMatrix result;
        set_zero(result, static_cast<std::size_t>(matrix.rows()));
        for (long j = 0; j < matrix.cols(); ++j)
            for (long i = 0; i < matrix.rows(); ++i)
                result.re[j][i] = matrix(i, j).real(), result.im[j][i] = matrix(i, j).imag();
        return result;
    }
    static Eigen::MatrixXcd lower(const SplitMatrix& split) {
        Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(GetParam(), GetParam());
        for (long j = 0; j < GetParam(); ++j)
            for (long i = j; i < GetParam(); ++i) result(i, j) = {split.re[j][i], split.im[j][i]};
        return result;
    }
    static double distance(const SplitMatrix& split, const Eigen::MatrixXcd& matrix) {
        const Eigen::MatrixXcd expected = matrix.triangularView<Eigen::Lower>();
        return (lower(split) - expected).norm() / (1.0 + expected.norm());
    }

    std::size_t size() const { return static_cast<std::size_t>(GetParam()); }

  private:
    std::mt19937_64 random_{static_cast<unsigned long>(GetParam())};
    std::normal_distribution<double> normal_;
};

TEST_P(SplitMatrices, InverseFactorAndDeterminantAreThoseOfEigen) {
    const Eigen::MatrixXcd model = hermitian();
    const Eigen::MatrixXcd factor = Eigen::LLT<Eigen::MatrixXcd>(model).matrixL();
    SplitMatrix given = split(model), inverse;
    const double own = invert_factor(given, size(), inverse);
    EXPECT_LT(distance(inverse, factor.inverse()), kRounding);
    EXPECT_NEAR(own, 2.0 * factor.diagonal().real().array().log().sum(), kRounding * static_cast<double>(size()));
    SplitMatrix again = split(model);
    EXPECT_EQ(log_determinant(again, size()), own);
}

// Pivots are multiplied before their logarithm is taken: sixteen of 1e-40 are nothing in a double, and of 1e40
// infinite.
TEST_P(SplitMatrices, DeterminantsMayBeTinyOrHuge) {
    const Eigen::MatrixXcd model = hermitian();
    SplitMatrix given = split(model);
    const double own = log_determinant(given, size());
    for (const double scale : {1e-120, 1e-40, 1e40, 1e120}) {
        SplitMatrix scaled = split(scale * model);
        const double expected = own + static_cast<double>(GetParam()) * std::log(scale);
        EXPECT_NEAR(log_determinant(scaled, size()), expected, 1e-14 * std::abs(expected) + kRounding) << scale;
    }
}

TEST_P(SplitMatrices, SandwichesAreThoseOfEigen) {
    const Eigen::MatrixXcd model = hermitian(), between = hermitian();
    const Eigen::MatrixXcd factor = Eigen::LLT<Eigen::MatrixXcd>(model).matrixL(), inverse_factor = factor.inverse();
    SplitMatrix given = split(model), inverse, result;
    invert_factor(given, size(), inverse);
    sandwich(inverse, split(between), size(), result);
    EXPECT_LT(distance(result, inverse_factor * between * inverse_factor.adjoint()), kRounding);
    const Eigen::VectorXd diagonal = between.diagonal().real();
    sandwich_diagonal(inverse, diagonal.data(), size(), result);
    EXPECT_LT(distance(result, inverse_factor * diagonal.asDiagonal() * inverse_factor.adjoint()), kRounding);
}

TEST_P(SplitMatrices, WhatIsNotDefiniteHasNoDeterminant) {
    Eigen::MatrixXcd model = hermitian();
    model(GetParam() - 1, GetParam() - 1) = -1.0;
    SplitMatrix given = split(model);
    EXPECT_TRUE(std::isnan(log_determinant(given, size())));
}

INSTANTIATE_TEST_SUITE_P(OfEverySize, SplitMatrices, testing::Range(1, static_cast<int>(kMostChannels) + 1));

}  // namespace
}  // namespace railpem::diagnosis

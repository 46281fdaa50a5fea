#include "diagnosis/likelihood/whitened_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace railpem::diagnosis {

namespace {

using Lane = std::array<double, WhitenedColumns::kLane>;

/// sum += (a + ib)·(x + iy), for a block of unknowns.
inline void add_product(double a, double b, const double* x, const double* y, Lane& re, Lane& im) {
#pragma omp simd
    for (std::size_t u = 0; u < re.size(); ++u) {
        re[u] += a * x[u] - b * y[u];
        im[u] += a * y[u] + b * x[u];
    }
}

/// sum += (a + ib)·(x − iy).
inline void add_product_with_conjugate(double a, double b, const double* x, const double* y, Lane& re, Lane& im) {
#pragma omp simd
    for (std::size_t u = 0; u < re.size(); ++u) {
        re[u] += a * x[u] + b * y[u];
        im[u] += b * x[u] - a * y[u];
    }
}

inline void write(double scale, const Lane& from, double* to) {
    for (std::size_t u = 0; u < from.size(); ++u) to[u] = scale * from[u];
}

}  // namespace

WhitenedColumns::WhitenedColumns(std::size_t channels, std::size_t unknowns, std::size_t dense)
    : channels_(channels),
      unknowns_(unknowns),
      dense_((dense + kLane - 1) / kLane * kLane),
      stride_(std::max((unknowns + 3) / 4 * 4, dense_)),
      inverse_re_(channels * channels),
      inverse_im_(channels * channels),
      re_(channels * channels * dense_),
      im_(re_.size()),
      half_re_(channels * channels),
      half_im_(channels * channels),
      rows_(static_cast<long>(kBins * channels * channels), static_cast<long>(stride_)),
      residual_(static_cast<long>(kBins * channels * channels)),
      scale_(static_cast<long>(channels * channels)),
      gradient_(Eigen::VectorXd::Zero(static_cast<long>(stride_))),
      information_(Eigen::MatrixXd::Zero(static_cast<long>(stride_), static_cast<long>(stride_))) {}

void WhitenedColumns::begin(const SplitMatrix& inverse_factor, double amplification) {
    amplification_ = amplification;
    for (std::size_t i = 0; i < channels_; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            inverse_re_[i * channels_ + j] = inverse_factor.re[j][i];
            inverse_im_[i * channels_ + j] = inverse_factor.im[j][i];
        }
    // Of unknowns that only add_diagonal() moves.
    rows_
        .block(static_cast<long>(bins_ * channels_ * channels_), static_cast<long>(dense_),
               static_cast<long>(channels_ * channels_), static_cast<long>(stride_ - dense_))
        .setZero();
}

void WhitenedColumns::set(std::size_t unknown, const std::complex<double>* derivative, const double* diagonal) {
    for (std::size_t j = 0; j < channels_; ++j) {
        at(re_, j, j)[unknown] = amplification_ * derivative[j * channels_ + j].real() * diagonal[j];
        for (std::size_t i = j + 1; i < channels_; ++i) {
            at(re_, i, j)[unknown] = amplification_ * derivative[j * channels_ + i].real();
            at(im_, i, j)[unknown] = amplification_ * derivative[j * channels_ + i].imag();
        }
    }
}

// In blocks of unknowns whose matrices stay in the innermost cache.
void WhitenedColumns::whiten() {
    for (std::size_t first = 0; first < dense_; first += kLane) whiten_block(first);
}

void WhitenedColumns::whiten_block(std::size_t first) {
    // H = L⁻¹D. Only its lower triangle is asked for: A_ij = Σ_{k≤j} H_ik conj(L⁻¹_jk), k ≤ j ≤ i.
    for (std::size_t i = 0; i < channels_; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            Lane re{}, im{};
            for (std::size_t k = 0; k <= i; ++k) {
                const double a = inverse_re_[i * channels_ + k], b = inverse_im_[i * channels_ + k];
                // D_kj = conj(D_jk) above the diagonal.
                if (k >= j)
                    add_product(a, b, at(re_, k, j) + first, at(im_, k, j) + first, re, im);
                else
                    add_product_with_conjugate(a, b, at(re_, j, k) + first, at(im_, j, k) + first, re, im);
            }
            half_re_[i * channels_ + j] = re;
            half_im_[i * channels_ + j] = im;
        }
    std::size_t row = bins_ * channels_ * channels_;
    for (std::size_t j = 0; j < channels_; ++j)
        for (std::size_t i = j; i < channels_; ++i) {
            Lane re{}, im{};
            for (std::size_t k = 0; k <= j; ++k)
                add_product(inverse_re_[j * channels_ + k], -inverse_im_[j * channels_ + k],
                            half_re_[i * channels_ + k].data(), half_im_[i * channels_ + k].data(), re, im);
            const double scale = i == j ? 1.0 : std::numbers::sqrt2;
            write(scale, re, rows_.row(static_cast<long>(row++)).data() + first);
            if (i != j) write(scale, im, rows_.row(static_cast<long>(row++)).data() + first);
        }
}

void WhitenedColumns::add_diagonal(std::size_t unknown, std::size_t channel, double power) {
    // Columns before the channel's own have nothing of it: L⁻¹ is lower triangular.
    std::size_t row = bins_ * channels_ * channels_ + channel * (2 * channels_ - channel);
    const long u = static_cast<long>(unknown);
    for (std::size_t j = channel; j < channels_; ++j) {
        const double c = inverse_re_[j * channels_ + channel], d = -inverse_im_[j * channels_ + channel];
        for (std::size_t i = j; i < channels_; ++i) {
            const double a = inverse_re_[i * channels_ + channel], b = inverse_im_[i * channels_ + channel];
            const double scale = power * (i == j ? 1.0 : std::numbers::sqrt2);
            rows_(static_cast<long>(row++), u) += scale * (a * c - b * d);
            if (i != j) rows_(static_cast<long>(row++), u) += scale * (a * d + b * c);
        }
    }
}

void WhitenedColumns::pack(const SplitMatrix& hermitian, double* packed) const {
    for (std::size_t j = 0; j < channels_; ++j)
        for (std::size_t i = j; i < channels_; ++i) {
            *packed++ = i == j ? hermitian.re[j][i] : std::numbers::sqrt2 * hermitian.re[j][i];
            if (i != j) *packed++ = std::numbers::sqrt2 * hermitian.im[j][i];
        }
}

void WhitenedColumns::end(const SplitMatrix& residual, const SplitMatrix& scale, double projection) {
    const long size = static_cast<long>(channels_ * channels_), first = static_cast<long>(bins_) * size;
    pack(residual, residual_.data() + first);
    if (projection > 0.0) {
        pack(scale, scale_.data());
        explained_.noalias() = rows_.middleRows(first, size).transpose() * scale_;
        information_.selfadjointView<Eigen::Lower>().rankUpdate(explained_, -projection);
    }
    if (++bins_ == kBins) flush();
}

void WhitenedColumns::flush() {
    const long count = static_cast<long>(bins_ * channels_ * channels_);
    const auto block = rows_.topRows(count);
    gradient_.noalias() += block.transpose() * residual_.head(count);
    information_.selfadjointView<Eigen::Lower>().rankUpdate(block.transpose(), 1.0);
    bins_ = 0;
}

void WhitenedColumns::accumulate(double weight, Eigen::VectorXd& gradient, Eigen::MatrixXd& information) {
    if (bins_ > 0) flush();
    const long count = static_cast<long>(unknowns_);
    gradient += weight * gradient_.head(count);
    information.triangularView<Eigen::Lower>() += weight * information_.topLeftCorner(count, count);
    gradient_.setZero();
    information_.setZero();
}

}  // namespace railpem::diagnosis

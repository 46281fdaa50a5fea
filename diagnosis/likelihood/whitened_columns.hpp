#pragma once
// Derivatives of many unknowns at one bin, whitened together: the inner loop of every fit.

#include <Eigen/Core>
#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "diagnosis/likelihood/split_matrix.hpp"

namespace railpem::diagnosis {

/// Whitened derivatives A_u = L⁻¹ ∂_uS L⁻ᴴ of the bins of a chunk as rows of real numbers whose dot products over all
/// rows are Σ tr(A_u A_v); unknowns lie side by side.
class WhitenedColumns {
  public:
    static constexpr std::size_t kLane = 8;  ///< unknowns of a block

    /// For matrices of `channels` × `channels` and `unknowns` unknowns, of which the first `dense` may be set() and the
    /// others only add_diagonal().
    WhitenedColumns(std::size_t channels, std::size_t unknowns, std::size_t dense);

    /// Begins a bin; `inverse_factor` is L⁻¹, lower triangular, column-major. What is set() is multiplied by
    /// `amplification`.
    void begin(const SplitMatrix& inverse_factor, double amplification = 1.0);
    /// The derivative of an unknown: Hermitian, column-major, its diagonal multiplied by `diagonal`. Every dense
    /// unknown's at every bin.
    void set(std::size_t unknown, const std::complex<double>* derivative, const double* diagonal);
    /// Whitens everything that was set.
    void whiten();
    /// Adds power·L⁻¹ e_c e_cᴴ L⁻ᴴ to an unknown's whitened derivative: the derivative of a power on a channel's
    /// diagonal. After whiten().
    void add_diagonal(std::size_t unknown, std::size_t channel, double power);
    /// Ends a bin with its whitened residual, Hermitian, column-major. The information becomes Mᵀ(1 − projection·aaᵀ)M,
    /// a the packed `scale` (whitened_bin.hpp); the gradient stays.
    void end(const SplitMatrix& residual, const SplitMatrix& scale, double projection);

    /// Σ over the bins so far, times `weight`, added to `gradient` and the lower triangle of `information`; begins
    /// anew.
    void accumulate(double weight, Eigen::VectorXd& gradient, Eigen::MatrixXd& information);

  private:
    static constexpr std::size_t kBins = 4;  ///< of a block that stays in the cache
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    void pack(const SplitMatrix& hermitian, double* packed) const;
    double* at(std::vector<double>& values, std::size_t i, std::size_t j) {
        return values.data() + (i * channels_ + j) * dense_;
    }
    void whiten_block(std::size_t first);
    void flush();

    std::size_t channels_, unknowns_, dense_, stride_;
    std::vector<double> inverse_re_, inverse_im_;               ///< [row][column]
    std::vector<double> re_, im_;                               ///< [row][column][unknown], lower triangle
    std::vector<std::array<double, kLane>> half_re_, half_im_;  ///< of a block, [row][column]
    Rows rows_;                                                 ///< of the block's bins
    Eigen::VectorXd residual_, scale_;
    double amplification_ = 1.0;
    Eigen::VectorXd explained_;  ///< √projection·Mᵀa of a bin
    std::size_t bins_ = 0;       ///< in the block
    Eigen::VectorXd gradient_;
    Eigen::MatrixXd information_;
};

}  // namespace railpem::diagnosis

#pragma once
// Symmetric matrices whose entries lie within three places of the diagonal: the rail in statics.

#include <Eigen/Core>

namespace railpem::track {

/// Lower band: entry (k, i) is A(i + k, i), k = 0 … 3. Entries beyond the last row are not used.
using SymmetricBand = Eigen::Matrix<double, 4, Eigen::Dynamic>;

/// A·x.
Eigen::VectorXd multiply(const SymmetricBand& matrix, const Eigen::VectorXd& x);

/// Solves A·x = b by LDLᵀ without pivoting, x in place of b, A destroyed. False when A is not positive definite; x is
/// undefined then.
bool solve_in_place(SymmetricBand& matrix, Eigen::VectorXd& x);

}  // namespace railpem::track

#pragma once

#include <Eigen/Core>

namespace railpem::simulate {

/// x ≥ 0 that minimises |A·x − b| (active set: Lawson & Hanson, Solving Least Squares Problems, 1974, algorithm NNLS).
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace railpem::simulate

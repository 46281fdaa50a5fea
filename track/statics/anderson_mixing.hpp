#pragma once
// Fixed points x = x + r(x) from the last few steps.

#include <Eigen/Dense>

namespace railpem::track {

/// Anderson's mixing (Walker & Ni 2011, SIAM J. Numer. Anal. 49, eq. 2.1): the next point of an iteration x → x + r(x)
/// is where the last `depth` differences of r, combined, would leave least. Superlinear where plain steps converge
/// slowly or alternate.
class AndersonMixing {
  public:
    explicit AndersonMixing(long depth = 5) : depth_(depth) {}

    /// The step from x, whose residual is `r` (same length in every call).
    Eigen::VectorXd step(const Eigen::VectorXd& x, const Eigen::VectorXd& r) {
        Eigen::VectorXd step = r;
        if (last_r_.size() == r.size()) {
            const long column = count_++ % depth_;
            if (count_ <= depth_)
                steps_.conservativeResize(r.size(), count_), residuals_.conservativeResize(r.size(), count_),
                    products_.conservativeResize(count_, count_);
            residuals_.col(column) = r - last_r_;
            steps_.col(column) = x - last_x_ + residuals_.col(column);
            products_.col(column).noalias() = residuals_.transpose() * residuals_.col(column);
            products_.row(column) = products_.col(column).transpose();
            const Eigen::VectorXd share = products_.ldlt().solve(residuals_.transpose() * r);
            if (share.allFinite()) step.noalias() -= steps_ * share;
        }
        last_x_ = x;
        last_r_ = r;
        return step;
    }

  private:
    long depth_;
    Eigen::MatrixXd residuals_, steps_;  ///< differences of r from step to step, and of x + r
    Eigen::MatrixXd products_;           ///< residuals_ᵀ·residuals_
    Eigen::VectorXd last_x_, last_r_;
    long count_ = 0;
};

}  // namespace railpem::track

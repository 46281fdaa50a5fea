#pragma once
// The best step of a second-order picture within bounds.

#include <Eigen/Core>

#include "diagnosis/fit/fit_settings.hpp"

namespace railpem::diagnosis {

/// The step δ that maximises g·δ − ½δᵀAδ with low ≤ δ ≤ high. A positive definite, low ≤ 0 ≤ high. An active set
/// (Lawson & Hanson 1974, chapter 23, with two bounds): what would leave its bounds stops there one after the other,
/// the rest is sought anew beside it, and what a bound no longer holds is let go. Every turn gains, so that the step
/// never promises less than none.
Eigen::VectorXd bounded_step(const Eigen::MatrixXd& curvature, const Eigen::VectorXd& gradient,
                             const Eigen::VectorXd& low, const Eigen::VectorXd& high,
                             const FitSettings& settings = kFitSettings);

}  // namespace railpem::diagnosis

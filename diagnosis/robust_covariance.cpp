#include "diagnosis/robust_covariance.hpp"

#include <algorithm>
#include <cmath>

namespace railpem::diagnosis {

namespace {

constexpr double kThirdOctave = 1.2599210498948732;  // 2^(1/3)

/// Blocks joined to third octaves; low down they are wider already.
std::vector<Eigen::VectorXd> third_octaves(const std::vector<GradientBlock>& blocks) {
    std::vector<Eigen::VectorXd> bands;
    const GradientBlock* first = nullptr;
    for (const GradientBlock& block : blocks) {
        if (first && block.observation == first->observation && block.frequency_hz < kThirdOctave * first->frequency_hz) {
            bands.back() += block.gradient;
            continue;
        }
        first = &block;
        bands.push_back(block.gradient);
    }
    return bands;
}

}  // namespace

Eigen::MatrixXd robust_covariance(const Fit& fit, const LikelihoodContext& context) {
    const auto derivatives = differentiate(fit.trial, fit.unknowns, fit.values, fit.predictions, context);
    const std::vector<Eigen::VectorXd> bands = third_octaves(gradient_blocks(fit.trial, fit.unknowns, fit.predictions, derivatives, context));
    if (bands.empty()) return fit.covariance;
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(fit.covariance.rows(), fit.covariance.cols());
    for (std::size_t u = 0; u < fit.unknowns.size(); ++u) scatter(static_cast<long>(u), static_cast<long>(u)) = 1.0 / (fit.unknowns[u].deviation * fit.unknowns[u].deviation);
    for (const Eigen::VectorXd& band : bands) scatter += band * band.transpose();
    const Eigen::VectorXd own = (fit.covariance * scatter * fit.covariance).diagonal().cwiseSqrt(), least = fit.covariance.diagonal().cwiseSqrt();
    const Eigen::VectorXd wider = own.cwiseQuotient(least).cwiseMax(1.0);
    return wider.asDiagonal() * fit.covariance * wider.asDiagonal();
}

}  // namespace railpem::diagnosis

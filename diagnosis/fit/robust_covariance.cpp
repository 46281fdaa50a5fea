#include "diagnosis/fit/robust_covariance.hpp"

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
        if (first && block.observation == first->observation &&
            block.frequency_hz < kThirdOctave * first->frequency_hz) {
            bands.back() += block.gradient;
            continue;
        }
        first = &block;
        bands.push_back(block.gradient);
    }
    return bands;
}

/// Variance of an effect's parameter by what its law gets wrong.
double law_variance(const Unknown& unknown, double coordinate) {
    const EffectParameter* parameter = parameter_of(unknown);
    const double deviation = parameter ? law_deviation(*parameter, coordinate) : 0.0;
    return deviation * deviation;
}

/// Σ g_b g_bᵀ + D⁻².
Eigen::MatrixXd scatter_of(const Fit& fit, const LikelihoodContext& context) {
    const auto derivatives = derivatives_of(fit, context);
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(fit.covariance.rows(), fit.covariance.cols());
    for (std::size_t u = 0; u < fit.unknowns.size(); ++u)
        scatter(static_cast<long>(u), static_cast<long>(u)) =
            1.0 / (fit.unknowns[u].deviation * fit.unknowns[u].deviation);
    for (const Eigen::VectorXd& band :
         third_octaves(gradient_blocks(fit.trial, fit.unknowns, fit.predictions, derivatives, context)))
        scatter += band * band.transpose();
    return scatter;
}

}  // namespace

double law_deviation(const EffectParameter& parameter, double coordinate, double least) {
    return std::abs(
        to_coordinate(parameter, (1.0 + std::max(least, parameter.inexact)) * from_coordinate(parameter, coordinate)) -
        coordinate);
}

Eigen::MatrixXd robust_covariance(const Fit& fit, const LikelihoodContext& context) {
    const Eigen::VectorXd variance = fit.covariance.diagonal();
    Eigen::VectorXd wider = (fit.covariance * scatter_of(fit, context) * fit.covariance).diagonal().cwiseMax(variance);
    for (std::size_t u = 0; u < fit.unknowns.size(); ++u)
        wider(static_cast<long>(u)) += law_variance(fit.unknowns[u], fit.values[u]);
    const Eigen::VectorXd factor = wider.cwiseQuotient(variance).cwiseSqrt();
    return factor.asDiagonal() * fit.covariance * factor.asDiagonal();
}

}  // namespace railpem::diagnosis

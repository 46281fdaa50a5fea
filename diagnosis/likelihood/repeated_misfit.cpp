#include "diagnosis/likelihood/repeated_misfit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "diagnosis/likelihood/likelihood_settings.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kNormalPerMad = 1.4826;

/// L⁻¹HL⁻ᴴ.
Eigen::MatrixXcd seen_through(const Eigen::LLT<Eigen::MatrixXcd>& factor, const Eigen::MatrixXcd& hermitian) {
    const Eigen::MatrixXcd half = factor.matrixL().solve(hermitian);
    return factor.matrixL().solve(half.adjoint().eval());
}

/// What a bin of one part is beyond its model, whitened, perpendicular to its power.
Eigen::MatrixXcd residual(const Eigen::MatrixXcd& model, const Eigen::VectorXd& noise,
                          const Eigen::MatrixXcd& estimate) {
    const Eigen::LLT<Eigen::MatrixXcd> factor(model);
    const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(model.rows(), model.cols());
    const Eigen::MatrixXcd scale = one - seen_through(factor, noise.cast<std::complex<double>>().asDiagonal());
    const double length = scale.squaredNorm();
    Eigen::MatrixXcd own = seen_through(factor, estimate) - one;
    if (length > 0.0) own -= scale * (scale.cwiseProduct(own.conjugate()).sum().real() / length);
    return own;
}

double median_of(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<long>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Standard deviation of the sum of `blocks`, a few of which may be far off.
double spread_of_sum(const std::vector<double>& blocks) {
    const double median = median_of(blocks);
    std::vector<double> distances;
    for (const double own : blocks) distances.push_back(std::abs(own - median));
    return kNormalPerMad * median_of(std::move(distances)) * std::sqrt(static_cast<double>(blocks.size()));
}

}  // namespace

RepeatedMisfit repeated_misfit(const Trial& trial, const Predictions& predictions, const LikelihoodContext& context) {
    RepeatedMisfit total;
    std::optional<Predictions> made;
    const Predictions& unseen = predictions_of(trial, predictions, context, Part::held_out, made);
    double variance = 0.0;
    for (std::size_t o = 0; o < context.observations->size(); ++o) {
        const Observation& observation = (*context.observations)[o];
        const MeasuredSpectra &fitted = observation.fitted, &held_out = observation.held_out;
        const long size = static_cast<long>(observation.channels.size());
        if (observation.scalar || fitted.values.empty() || held_out.values.empty()) continue;
        const double averages = fitted.averages + held_out.averages;
        std::vector<double> blocks(1, 0.0);
        double block = std::floor(observation.frequency(0) / kLikelihoodSettings.block_hz), own = 0.0, chance = 0.0;
        for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
            const auto matrix = [&](const MeasuredSpectra& part) -> Eigen::MatrixXcd {
                return Eigen::Map<const Eigen::MatrixXcd>(&part.values[bin * static_cast<std::size_t>(size * size)],
                                                          size, size);
            };
            const Eigen::VectorXd noise = noise_powers(trial, observation, o, bin);
            const Eigen::MatrixXcd first = residual(complete_prediction(trial, observation, o, predictions[o], bin),
                                                    noise, matrix(fitted)),
                                   second = residual(complete_prediction(trial, observation, o, unseen[o], bin), noise,
                                                     matrix(held_out));
            const double nats = 0.5 * averages * first.cwiseProduct(second.conjugate()).sum().real();
            if (const double at = std::floor(observation.frequency(bin) / kLikelihoodSettings.block_hz); at != block)
                block = at, blocks.push_back(0.0);
            blocks.back() += nats;
            own += nats;
            chance +=
                0.25 * averages * averages * static_cast<double>(size * size) / (fitted.averages * held_out.averages);
        }
        total.nats += own;
        total.seconds += fitted.seconds + held_out.seconds;
        const double seen = spread_of_sum(blocks);
        variance += std::max(chance, seen * seen);
    }
    total.deviation = std::sqrt(variance);
    return total;
}

}  // namespace railpem::diagnosis

#include "diagnosis/judge/constancy.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "diagnosis/fit/robust_covariance.hpp"
#include "diagnosis/hypotheses/screen.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kLeastInexact = 0.01;  ///< of a value: of what the best laws get wrong no recording has the same

/// The derivatives of one unknown, one observation each.
std::vector<const PredictionDerivative*> derivatives_with(const std::vector<PredictionDerivative>& derivatives,
                                                          std::size_t unknown,
                                                          const std::vector<Observation>& observations) {
    std::vector<const PredictionDerivative*> own;
    for (const PredictionDerivative& derivative : derivatives) {
        const auto is_zero = [](const std::complex<double>& value) { return value == 0.0; };
        if (derivative.unknown == static_cast<int>(unknown) &&
            !observations[static_cast<std::size_t>(derivative.observation)].scalar &&
            !std::all_of(derivative.values.begin(), derivative.values.end(), is_zero))
            own.push_back(&derivative);
    }
    return own;
}

/// Differences of all but the last observation from the last, as unknowns of their own.
std::vector<Unknown> differences(const Unknown& common, const std::vector<const PredictionDerivative*>& derivatives) {
    std::vector<Unknown> own;
    for (std::size_t i = 0; i + 1 < derivatives.size(); ++i)
        own.push_back({.kind = UnknownKind::effect,
                       .name = common.name,
                       .deviation = common.deviation,
                       .observation = derivatives[i]->observation,
                       .index = common.index,
                       .set = {}});
    return own;
}

/// ½ Δᵀ(C + V)⁻¹Δ. All differences share the last observation's error.
double nats_of(const FreedomPromise& promise, double law) {
    const long count = promise.values.size();
    const Eigen::MatrixXd spread =
        promise.covariance +
        law * law * (Eigen::MatrixXd::Identity(count, count) + Eigen::MatrixXd::Ones(count, count));
    return 0.5 * promise.values.dot(spread.ldlt().solve(promise.values));
}

}  // namespace

std::vector<ParameterByRecording> constancy(const Fit& fit, const LikelihoodContext& context) {
    const std::vector<PredictionDerivative> derivatives = derivatives_of(fit, context);
    std::vector<ParameterByRecording> found;
    std::vector<std::vector<const PredictionDerivative*>> known;
    std::vector<std::vector<Unknown>> freedoms;
    for (std::size_t u = 0; u < fit.unknowns.size(); ++u) {
        if (fit.unknowns[u].kind != UnknownKind::effect) continue;
        std::vector<const PredictionDerivative*> own = derivatives_with(derivatives, u, *context.observations);
        if (own.size() < 2) continue;
        found.push_back({.unknown = u, .observation = {}, .value = {}});
        freedoms.push_back(differences(fit.unknowns[u], own));
        known.push_back(std::move(own));
    }
    if (found.empty()) return found;
    const auto given = [&](std::size_t i) {
        std::vector<PredictionDerivative> own;
        for (std::size_t d = 0; d + 1 < known[i].size(); ++d)
            own.push_back({known[i][d]->observation, static_cast<int>(d), known[i][d]->values});
        return own;
    };
    const std::vector<FreedomPromise> promises = promises_of(fit, freedoms, context, given);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Unknown& unknown = fit.unknowns[found[i].unknown];
        const double common = fit.values[found[i].unknown] + promises[i].move(static_cast<long>(found[i].unknown));
        const EffectParameter& parameter = *parameter_of(unknown);
        for (std::size_t d = 0; d < known[i].size(); ++d) {
            found[i].observation.push_back(static_cast<std::size_t>(known[i][d]->observation));
            found[i].value.push_back(from_coordinate(
                parameter, common + (d + 1 < known[i].size() ? promises[i].values(static_cast<long>(d)) : 0.0)));
        }
        found[i].nats = nats_of(promises[i], law_deviation(parameter, fit.values[found[i].unknown], kLeastInexact));
    }
    return found;
}

}  // namespace railpem::diagnosis

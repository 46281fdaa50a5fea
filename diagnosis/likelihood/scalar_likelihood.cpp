#include "diagnosis/likelihood/scalar_likelihood.hpp"

#include <cassert>
#include <cmath>

namespace railpem::diagnosis {

namespace {

/// Visits every value of the part: variance without and with discrepancy, and whether its phase counts.
template <class Visit>
void each_value(const Observation& observation, std::size_t o, const Trial& trial, const LikelihoodContext& context,
                const Visit& visit) {
    const ScalarData& data = *observation.scalar;
    for (std::size_t i = 0; i < data.values.size(); ++i) {
        const ScalarValue& value = data.values[i];
        if (belongs(value, context.part))
            visit(i, value, scalar_variance(value, trial.discrepancy[o], context.least_floor));
    }
}

/// The discrepancy of a recording among the unknowns, or −1.
int discrepancy_unknown(const std::vector<Unknown>& unknowns, std::size_t observation) {
    for (std::size_t u = 0; u < unknowns.size(); ++u)
        if (unknowns[u].kind == UnknownKind::discrepancy && unknowns[u].observation == static_cast<int>(observation))
            return static_cast<int>(u);
    return -1;
}

void add_observation(const Trial& trial, const std::vector<Unknown>& unknowns, std::size_t o,
                     const ExpectedSpectra& prediction, const std::vector<const PredictionDerivative*>& own,
                     const LikelihoodContext& context, LikelihoodSlope& slope) {
    const Observation& observation = (*context.observations)[o];
    const ScalarData& data = *observation.scalar;
    const int parts = data.has_phase ? 2 : 1;
    const int discrepancy = discrepancy_unknown(unknowns, data.leader.value_or(o));
    each_value(observation, o, trial, context, [&](std::size_t i, const ScalarValue& value, double variance) {
        for (int part = 0; part < parts; ++part) {
            const auto of = [part](std::complex<double> z) { return part == 0 ? z.real() : z.imag(); };
            const double residual = of(prediction.values[i]);
            for (std::size_t a = 0; a < own.size(); ++a) {
                const double first = of(own[a]->values[i]);
                if (first == 0.0) continue;
                slope.gradient(own[a]->unknown) -= first * residual / variance;
                for (const PredictionDerivative* other : own)
                    slope.information(own[a]->unknown, other->unknown) += first * of(other->values[i]) / variance;
            }
            if (discrepancy < 0) continue;
            // d log(s²)/d log δ; mean and variance of a Gaussian inform independently.
            const double relative = 2.0 * value.sharing * trial.discrepancy[o] * trial.discrepancy[o] / variance;
            slope.gradient(discrepancy) += 0.5 * relative * (residual * residual / variance - 1.0);
            slope.information(discrepancy, discrepancy) += 0.5 * relative * relative;
        }
    });
}

}  // namespace

long discrepancy_cell(double frequency_hz) {
    return std::lround(kObservationSettings.discrepancy_cells * std::log2(frequency_hz));
}

bool belongs(const ScalarValue& value, Part part) {
    return part == Part::all || (part == Part::held_out) == value.held_out;
}

std::size_t scalar_count(const std::vector<Observation>& observations, Part part) {
    std::size_t count = 0;
    for (const Observation& observation : observations)
        if (observation.scalar)
            for (const ScalarValue& value : observation.scalar->values) count += belongs(value, part);
    return count;
}

double db_per_neper(recordings::RecordingKind kind) {
    return (kind == recordings::RecordingKind::receptance ? 20.0 : 10.0) / std::log(10.0);
}

double scalar_variance(const ScalarValue& value, double discrepancy, double least_floor) {
    return value.deviation * value.deviation + value.sharing * (value.shared_deviation * value.shared_deviation +
                                                                discrepancy * discrepancy + least_floor * least_floor);
}

double scalar_log_likelihood(const Trial& trial, const Predictions& predictions, const LikelihoodContext& context) {
    double sum = 0.0;
    for (std::size_t o = 0; o < context.observations->size(); ++o) {
        const Observation& observation = (*context.observations)[o];
        if (!observation.scalar) continue;
        const double parts = observation.scalar->has_phase ? 2.0 : 1.0;
        each_value(observation, o, trial, context, [&](std::size_t i, const ScalarValue& value, double variance) {
            sum -= 0.5 * (std::norm(predictions[o].values[i]) / variance +
                          parts * std::log(variance / (value.deviation * value.deviation)));
        });
    }
    return sum;
}

void add_scalar_slope(const Trial& trial, const std::vector<Unknown>& unknowns, const Predictions& predictions,
                      const std::vector<PredictionDerivative>& derivatives, const LikelihoodContext& context,
                      LikelihoodSlope& slope) {
    slope.log_likelihood += scalar_log_likelihood(trial, predictions, context);
    for (std::size_t o = 0; o < context.observations->size(); ++o) {
        if (!(*context.observations)[o].scalar) continue;
        std::vector<const PredictionDerivative*> own;
        for (const PredictionDerivative& derivative : derivatives)
            if (derivative.observation == static_cast<int>(o) && !derivative.values.empty()) {
                assert(derivative.first_bin == 0);
                own.push_back(&derivative);
            }
        add_observation(trial, unknowns, o, predictions[o], own, context, slope);
    }
}

}  // namespace railpem::diagnosis

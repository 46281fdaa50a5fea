#include "diagnosis/judge/constant_friction.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <complex>
#include <cstddef>
#include <memory>

#include "diagnosis/expectation/friction_spectra.hpp"
#include "diagnosis/hypotheses/screen.hpp"
#include "parameters/parameter_error.hpp"
#include "pem/coupling/excite.hpp"
#include "pem/coupling/linearise.hpp"
#include "pem/threads.hpp"

namespace railpem::diagnosis {

namespace {

bool has_friction_in(const Trial& trial, const LikelihoodContext& context, const Observation& observation) {
    return !observation.scalar && has_friction(case_of(trial, *context.believed, observation));
}

StageFriction realised_in(const Trial& trial, const LikelihoodContext& context, std::size_t index) {
    const pem::CaseParameters parameters = case_of(trial, *context.believed, (*context.observations)[index]);
    const double speed = trial.speed_m_per_s[index];
    pem::CoupledModel model = pem::coupled_model(parameters, speed);
    const std::vector<pem::Source> sources = pem::excitation_sources(parameters, model.wheels_m, speed);
    const std::vector<pem::RailGroup> rails = pem::linearisation_rails(parameters, model);
    pem::linearise(parameters, sources, model, &rails);
    return realised_friction(parameters, model, {sources, rails});
}

std::vector<Observation> that_expect_it(const Trial& trial, const LikelihoodContext& context) {
    std::vector<Observation> observations = *context.observations;
    pem::TeamFailure failure;
#pragma omp parallel for schedule(dynamic, 1) num_threads(pem::thread_count(context.threads))
    for (std::size_t o = 0; o < observations.size(); ++o)
        failure.guard([&] {
            if (has_friction_in(trial, context, observations[o]))
                observations[o].expectation.realised_friction =
                    std::make_shared<StageFriction>(realised_in(trial, context, o));
        });
    failure.rethrow();
    return observations;
}

MeasuredSpectra& part_of(Observation& observation, Part part) {
    return part == Part::fitted ? observation.fitted : part == Part::held_out ? observation.held_out : observation.all;
}

/// The trial that is fitted where the fit is when its recordings pull like that, by one step.
Trial moved_against(const Fit& fit, const Eigen::VectorXd& gradient) {
    const Eigen::VectorXd step = fit.covariance * gradient;
    std::vector<double> values = fit.values;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = std::clamp(values[i] - step(static_cast<long>(i)), fit.unknowns[i].low, fit.unknowns[i].high);
    Trial moved = fit.trial;
    set_values(moved, fit.unknowns, values);
    return moved;
}

}  // namespace

Unknown power_of_friction() {
    return {.kind = UnknownKind::correction, .name = "power of friction's own forces", .mean = 0.0, .deviation = 1.0};
}

/// The prediction is linear in the power: its derivative is the difference of the prediction with these forces and
/// without.
std::vector<PredictionDerivative> derivatives_with_power(const Fit& fit, const LikelihoodContext& context) {
    std::vector<Observation> silenced = *context.observations;
    for (Observation& own : silenced) own.expectation.friction_power = 0.0;
    LikelihoodContext silent = context;
    silent.observations = &silenced;
    std::vector<PredictionDerivative> derivatives;
    for (std::size_t o = 0; o < silenced.size(); ++o) {
        if (!has_friction_in(fit.trial, context, silenced[o])) continue;
        const ExpectedSpectra without = predict_like(fit.predictions, fit.trial, silent, o, Reuse::rail);
        PredictionDerivative own{.observation = static_cast<int>(o), .unknown = 0, .values = fit.predictions[o].values};
        for (std::size_t i = 0; i < own.values.size(); ++i) own.values[i] -= without.values[i];
        derivatives.push_back(std::move(own));
    }
    return derivatives;
}

std::vector<Observation> with_constant_friction(const Trial& trial, const LikelihoodContext& context) {
    const std::vector<Observation> expecting = that_expect_it(trial, context);
    LikelihoodContext asked = context;
    asked.observations = &expecting;
    const Predictions predictions = predict(trial, asked);
    std::vector<Observation> result = *context.observations;
    for (std::size_t o = 0; o < result.size(); ++o) {
        if (result[o].scalar) continue;
        const long size = static_cast<long>(predictions[o].channels);
        std::complex<double>* values = part_of(result[o], context.part).values.data();
        for (std::size_t b = 0; b < predictions[o].bins(); ++b)
            Eigen::Map<Eigen::MatrixXcd>(values + static_cast<long>(b) * size * size, size, size) =
                complete_prediction(trial, result[o], o, predictions[o], b, context.least_floor);
    }
    return result;
}

double power_of_constant(const Fit& fit, const LikelihoodContext& context,
                         const std::vector<PredictionDerivative>& with_power) {
    Fit there = fit;
    restore_derivatives(there, context);
    std::vector<Observation> drawn = with_constant_friction(fit.trial, context);
    LikelihoodContext own = context;
    own.observations = &drawn;
    const auto pull = [&] {
        return likelihood_slope(fit.trial, fit.unknowns, fit.predictions, there.derivatives->values, own).gradient;
    };
    there.gradient = pull();
    try {
        drawn = with_constant_friction(moved_against(fit, there.gradient), context);
        there.gradient = pull();
    } catch (const parameters::ParameterError&) {  // one step leads where nothing can run: the fit's own case is asked
    }
    return 1.0 +
           promises_of(there, {{power_of_friction()}}, own, [&](std::size_t) { return with_power; }).front().values(0);
}

}  // namespace railpem::diagnosis

#include "diagnosis/findings/fit_figures.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <optional>

#include "diagnosis/judge/compare_channels.hpp"
#include "diagnosis/likelihood/scalar_likelihood.hpp"

namespace railpem::diagnosis {

namespace {

LikelihoodContext of_part(LikelihoodContext context, Part part) {
    context.part = part;
    return context;
}

/// Σ n [tr(S⁻¹Ŝ) − p]: what is above its expectation under the fit itself.
double excess(const Fit& fit, const Predictions& predictions, const LikelihoodContext& context) {
    double sum = 0.0;
    for (std::size_t o = 0; o < context.observations->size(); ++o) {
        const Observation& observation = (*context.observations)[o];
        const MeasuredSpectra& data = measured(observation, context.part);
        const std::size_t size = observation.channels.size();
        for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
            const Eigen::MatrixXcd model = complete_prediction(fit.trial, observation, o, predictions[o], bin);
            const Eigen::Map<const Eigen::MatrixXcd> estimate(&data.values[bin * size * size], static_cast<long>(size),
                                                              static_cast<long>(size));
            sum += data.averages * (model.llt().solve(estimate).trace().real() - static_cast<double>(size));
        }
    }
    return sum;
}

}  // namespace

FigureScale::FigureScale(const Fit& diagnosed, const LikelihoodContext& context)
    : diagnosed_(diagnosed), context_(context) {
    const LikelihoodContext held = of_part(context, Part::held_out);
    std::optional<Predictions> made;
    const Predictions& unseen = predictions_of(diagnosed.trial, diagnosed.predictions, context, Part::held_out, made);
    unseen_reference_ = log_likelihood(diagnosed.trial, unseen, held) + excess(diagnosed, unseen, held) -
                        scalar_log_likelihood(diagnosed.trial, unseen, held);
}

FitFigures FigureScale::of(const Trial& trial, const Predictions& predictions, Part part) const {
    std::optional<Predictions> made, made_of_diagnosed;
    const Predictions& own = predictions_of(trial, predictions, context_, part, made);
    const Predictions& diagnosed =
        predictions_of(diagnosed_.trial, diagnosed_.predictions, context_, part, made_of_diagnosed);
    // of which the last only says what speaks
    const Stages stages{&trial, &own, &trial, &own, &diagnosed_.trial, &diagnosed};
    return {rms_db(compare_channels(stages, *context_.observations, part), Stage::retuned),
            log_likelihood_of(trial, own, part) / seconds(part)};
}

double FigureScale::seconds(Part part) const {
    double sum = 0.0;
    for (const Observation& observation : *context_.observations) sum += measured(observation, part).seconds;
    return sum > 0.0 ? sum : std::max(1.0, static_cast<double>(scalar_count(*context_.observations, part)));
}

double FigureScale::log_likelihood_of(const Trial& trial, const Predictions& predictions, Part part) const {
    return log_likelihood(trial, predictions, of_part(context_, part)) -
           (part == Part::held_out ? unseen_reference_ : 0.0);
}

}  // namespace railpem::diagnosis

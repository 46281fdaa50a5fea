#include "diagnosis/fit/imperfection_derivatives.hpp"

#include "diagnosis/expectation/faint_sources.hpp"
#include "diagnosis/fit/node_weight.hpp"
#include "diagnosis/observations/channel_scales.hpp"
#include "pem/coupling/excite.hpp"

namespace railpem::diagnosis {

using Values = std::vector<std::complex<double>>;

Values met_alone_spectra(const Trial& trial, const LikelihoodContext& context, std::size_t o,
                         const Predictions& predictions) {
    const Observation& observation = (*context.observations)[o];
    const ExpectationCache& known = predictions.caches[o];
    const pem::CaseParameters parameters = case_of(trial, *context.believed, observation);
    ExpectedSpectra alone{.first_bin = predictions[o].first_bin, .channels = predictions[o].channels, .values = {}};
    alone.values.assign(predictions[o].values.size(), 0.0);
    if (!parameters.modifiers.has_met_alone()) return alone.values;
    const double speed = trial.speed_m_per_s[o];
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const pem::Excitation excitation = pem::excitation(parameters, wheels, speed, &known.track);
    add_met_alone(parameters, known.transfers, excitation.broadband.front(), wheels, speed, observation.kernel.bin_hz(),
                  alone);
    scale_channels(trial.log_gain[o], alone.values);
    return alone.values;
}

std::vector<Values> met_alone_derivatives(const Trial& trial, const std::vector<const Unknown*>& unknowns,
                                          const LikelihoodContext& context, std::size_t o,
                                          const Predictions& predictions) {
    const Observation& observation = (*context.observations)[o];
    const ExpectedSpectra& at = predictions[o];
    const Values alone = met_alone_spectra(trial, context, o, predictions);
    const std::size_t elements = at.channels * at.channels;
    std::vector<Values> result;
    for (const Unknown* unknown : unknowns) {
        const NodeWeight weight(trial.numbers.modifiers.met_alone.wavelength_m, unknown->index, trial.speed_m_per_s[o]);
        Values own(alone.size());
        for (std::size_t b = 0; b < at.bins(); ++b) {
            const double share = weight(static_cast<double>(at.first_bin + b) * observation.kernel.bin_hz());
            for (std::size_t i = b * elements; i < (b + 1) * elements; ++i) own[i] = share * alone[i];
        }
        result.push_back(std::move(own));
    }
    return result;
}

Values calibration_derivative(const ExpectedSpectra& prediction, std::size_t channel) {
    const std::size_t size = prediction.channels;
    Values own(prediction.values.size(), 0.0);
    for (std::size_t b = 0; b < prediction.bins(); ++b)
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t row = (b * size + i) * size + channel, column = (b * size + channel) * size + i;
            own[row] += 0.5 * prediction.values[row];
            own[column] += 0.5 * prediction.values[column];
        }
    return own;
}

}  // namespace railpem::diagnosis

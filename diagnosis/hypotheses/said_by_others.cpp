#include "diagnosis/hypotheses/said_by_others.hpp"

#include <Eigen/Cholesky>

#include "diagnosis/likelihood/likelihood.hpp"

namespace railpem::diagnosis {

namespace {

SaidByOthers said_of(long channel, const Eigen::MatrixXcd& inverse, const Eigen::MatrixXcd& data) {
    Eigen::VectorXcd weights = -inverse.col(channel) / inverse(channel, channel).real();
    weights(channel) = 0.0;
    return {.cross = weights.dot(data.col(channel)),
            .said = weights.dot(data * weights).real(),
            .measured = data(channel, channel).real()};
}

}  // namespace

void for_each_said_by_others(const Fit& fit, const LikelihoodContext& context,
                             const std::function<void(const SaidByOthers&)>& with) {
    for (std::size_t o = 0; o < context.observations->size(); ++o) {
        const Observation& observation = (*context.observations)[o];
        const MeasuredSpectra& data = measured(observation, context.part);
        const long size = static_cast<long>(observation.channels.size());
        if (observation.scalar || size < 2) continue;
        const Eigen::MatrixXcd identity = Eigen::MatrixXcd::Identity(size, size);
        for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
            const Eigen::MatrixXcd own = Eigen::Map<const Eigen::MatrixXcd>(
                &data.values[bin * static_cast<std::size_t>(size * size)], size, size);
            const Eigen::MatrixXcd expected =
                complete_prediction(fit.trial, observation, o, fit.predictions[o], bin, context.least_floor);
            const Eigen::MatrixXcd inverse = expected.llt().solve(identity);
            for (long c = 0; c < size; ++c) {
                SaidByOthers said = said_of(c, inverse, own);
                said.response = observation.channels[static_cast<std::size_t>(c)].response;
                said.frequency_hz = observation.frequency(bin);
                said.expected = expected(c, c).real();
                with(said);
            }
        }
    }
}

}  // namespace railpem::diagnosis

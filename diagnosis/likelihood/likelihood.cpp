#include "diagnosis/likelihood/likelihood.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "diagnosis/likelihood/likelihood_settings.hpp"
#include "diagnosis/likelihood/scalar_likelihood.hpp"
#include "diagnosis/likelihood/whitened_bin.hpp"
#include "diagnosis/likelihood/whitened_columns.hpp"
#include "diagnosis/model/effort.hpp"
#include "diagnosis/model/predict_scalars.hpp"
#include "diagnosis/observations/channel_scales.hpp"
#include "pem/threads.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;

int thread_count(const LikelihoodContext& context) {
    return pem::thread_count(context.threads);
}

const BinPower* known_power(const LikelihoodContext& context, std::size_t observation, std::size_t bin) {
    return context.powers ? &context.powers->at[observation][bin] : nullptr;
}

/// Averages that a bin speaks for.
double weight_of(const LikelihoodContext& context, const MeasuredSpectra& data) {
    return static_cast<double>(context.every) * data.averages;
}

/// Bins of an observation that are summed together.
struct Chunk {
    std::size_t observation, first, count;
};

std::vector<Chunk> chunks_of(const std::vector<Observation>& observations,
                             std::size_t bins = kLikelihoodSettings.chunk_bins) {
    std::vector<Chunk> chunks;
    for (std::size_t o = 0; o < observations.size(); ++o)
        for (std::size_t first = 0; first < observations[o].bins(); first += bins)
            chunks.push_back({o, first, std::min(bins, observations[o].bins() - first)});
    return chunks;
}

/// The unknowns that move a chunk, in the order of its columns, and how.
struct ChunkUnknowns {
    std::vector<const PredictionDerivative*> derivatives;
    std::vector<std::size_t> noise, floors;  ///< indices of unknowns
    std::size_t size() const { return derivatives.size() + noise.size() + floors.size(); }
};

ChunkUnknowns unknowns_of(const Chunk& chunk, const std::vector<Unknown>& unknowns, const Observation& observation,
                          const std::vector<PredictionDerivative>& derivatives) {
    ChunkUnknowns own;
    const std::size_t size = observation.channels.size();
    for (const PredictionDerivative& derivative : derivatives) {
        if (derivative.observation != static_cast<int>(chunk.observation) || derivative.values.empty()) continue;
        const std::size_t first = derivative.first_bin * size * size, from = std::max(chunk.first * size * size, first),
                          to = std::min((chunk.first + chunk.count) * size * size, first + derivative.values.size());
        bool zero = true;  // many unknowns of the irregularity move a few bins only
        for (std::size_t i = from; i < to && zero; ++i) zero = derivative.values[i - first] == 0.0;
        if (!zero) own.derivatives.push_back(&derivative);
    }
    const int low = floor_place(observation.frequency(chunk.first)).node,
              high = floor_place(observation.frequency(chunk.first + chunk.count - 1)).node + 1;
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
        const int node = unknowns[u].index % kFloorNodeCount;
        const bool is_noise = unknowns[u].kind == UnknownKind::noise || unknowns[u].kind == UnknownKind::flicker;
        if (is_noise && unknowns[u].observation == static_cast<int>(chunk.observation)) own.noise.push_back(u);
        if (unknowns[u].kind == UnknownKind::floor && node >= low && node <= high) own.floors.push_back(u);
    }
    return own;
}

/// A derivative at a bin, where it has none `nothing`.
const Complex* values_at(const PredictionDerivative& derivative, std::size_t bin, std::size_t elements,
                         const std::vector<Complex>& nothing) {
    const bool has = bin >= derivative.first_bin && (bin - derivative.first_bin) * elements < derivative.values.size();
    return has ? &derivative.values[(bin - derivative.first_bin) * elements] : nothing.data();
}

/// Columns of the noise and of the floor: derivatives of powers on the diagonal.
void add_diagonal_columns(const Trial& trial, const std::vector<Unknown>& unknowns, const ChunkUnknowns& own,
                          const Observation& observation, std::size_t index, const ExpectedSpectra& prediction,
                          std::size_t bin, double amplification, WhitenedColumns& columns) {
    const FloorPlace place = floor_place(observation.frequency(bin));
    const std::array<double, kFloorGroups> floors = floors_at(trial, observation.frequency(bin), 0.0);
    const std::size_t size = prediction.channels;
    const Complex* model = &prediction.values[bin * size * size];
    std::size_t column = own.derivatives.size();
    for (const std::size_t u : own.noise) {
        const std::size_t c = static_cast<std::size_t>(unknowns[u].index);
        const bool white = unknowns[u].kind == UnknownKind::noise;
        columns.add_diagonal(
            column++, c, white ? trial.noise_psd[index][c] : trial.flicker_psd[index][c] / observation.frequency(bin));
    }
    for (const std::size_t u : own.floors) {
        const int node = unknowns[u].index % kFloorNodeCount;
        const auto group = static_cast<std::size_t>(unknowns[u].index / kFloorNodeCount);
        const double share = node == place.node ? 1.0 - place.share : node == place.node + 1 ? place.share : 0.0;
        for (std::size_t c = 0; c < size && share > 0.0; ++c)
            if (floor_group(observation.channels[c].response) == group)
                columns.add_diagonal(column, c,
                                     amplification * 2.0 * share * floors[group] * model[c * (size + 1)].real());
        ++column;
    }
}

/// The sums over one chunk.
LikelihoodSlope chunk_slope(const Chunk& chunk, const Trial& trial, const std::vector<Unknown>& unknowns,
                            const Predictions& predictions, const std::vector<PredictionDerivative>& derivatives,
                            const LikelihoodContext& context) {
    const std::size_t o = chunk.observation;
    const Observation& observation = (*context.observations)[o];
    const MeasuredSpectra& data = measured(observation, context.part);
    const std::size_t size = observation.channels.size();
    const ChunkUnknowns own = unknowns_of(chunk, unknowns, observation, derivatives);
    WhitenedColumns columns(size, own.size(), own.derivatives.size());
    LikelihoodSlope slope;
    std::vector<double> diagonal(size);
    const std::vector<Complex> nothing(size * size);
    WhitenedBin white;
    const double weight = weight_of(context, data);
    for (std::size_t bin = chunk.first; bin < chunk.first + chunk.count; bin += context.every) {
        whiten(trial, observation, o, predictions[o], data, bin, context.least_floor, known_power(context, o, bin),
               white);
        slope.log_likelihood += weight * white.log_likelihood;
        if (!std::isfinite(white.log_likelihood)) continue;
        const std::array<double, kFloorGroups> floors =
            floors_at(trial, observation.frequency(bin), context.least_floor);
        // the floor grows with the prediction
        for (std::size_t c = 0; c < size; ++c)
            diagonal[c] = 1.0 + floors[floor_group(observation.channels[c].response)];
        columns.begin(white.inverse_factor, white.amplification);
        for (std::size_t d = 0; d < own.derivatives.size(); ++d)
            columns.set(d, values_at(*own.derivatives[d], bin, size * size, nothing), diagonal.data());
        columns.whiten();
        add_diagonal_columns(trial, unknowns, own, observation, o, predictions[o], bin, white.amplification, columns);
        columns.end(white.residual, white.scale, white.projection);
    }
    const long count = static_cast<long>(own.size());
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count);
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(count, count);
    columns.accumulate(weight, gradient, information);
    std::vector<long> at;
    for (const PredictionDerivative* derivative : own.derivatives) at.push_back(derivative->unknown);
    for (const std::size_t u : own.noise) at.push_back(static_cast<long>(u));
    for (const std::size_t u : own.floors) at.push_back(static_cast<long>(u));
    slope.gradient = Eigen::VectorXd::Zero(static_cast<long>(unknowns.size()));
    slope.information = Eigen::MatrixXd::Zero(static_cast<long>(unknowns.size()), static_cast<long>(unknowns.size()));
    for (long i = 0; i < count; ++i) {
        slope.gradient(at[static_cast<std::size_t>(i)]) += gradient(i);
        for (long j = 0; j <= i; ++j)
            slope.information(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)]) += information(i, j);
    }
    return slope;
}

}  // namespace

Eigen::VectorXd noise_powers(const Trial& trial, const Observation& observation, std::size_t index, std::size_t bin) {
    Eigen::VectorXd noise(static_cast<long>(observation.channels.size()));
    for (std::size_t c = 0; c < observation.channels.size(); ++c)
        noise(static_cast<long>(c)) = noise_at(trial, index, c, observation.frequency(bin));
    return noise;
}

Eigen::MatrixXcd complete_prediction(const Trial& trial, const Observation& observation, std::size_t index,
                                     const ExpectedSpectra& prediction, std::size_t bin, double least_floor) {
    Eigen::MatrixXcd model = prediction.matrix(bin);
    const std::array<double, kFloorGroups> floors = floors_at(trial, observation.frequency(bin), least_floor);
    for (long c = 0; c < model.rows(); ++c) {
        const double floor = floors[floor_group(observation.channels[static_cast<std::size_t>(c)].response)];
        model(c, c) = model(c, c).real() * (1.0 + floor) +
                      noise_at(trial, index, static_cast<std::size_t>(c), observation.frequency(bin));
    }
    return model;
}

ExpectedSpectra predict_one(const Trial& trial, const LikelihoodContext& context, std::size_t o,
                            const ExpectationCache* known, Reuse reuse, ExpectationCache* filled) {
    const Observation& observation = (*context.observations)[o];
    const pem::CaseParameters parameters = case_of(trial, *context.believed, observation);
    if (context.effort)
        context.effort->add(effort_of_prediction(
            parameters, observation.scalar ? observation.scalar->values.size() : observation.bins(), reuse,
            observation.expectation.sharp));
    if (!observation.scalar) {
        ExpectedSpectra spectra =
            expected_spectra(parameters, trial.speed_m_per_s[o], observation.kernel, observation.channels, {},
                             expectation_of(observation, context.part), known, reuse, filled);
        scale_channels(trial.log_gain[o], spectra.values);
        return spectra;
    }
    ExpectedSpectra result{.values =
                               predict_scalars(parameters, trial.speed_m_per_s[o], observation, known, reuse, filled)};
    for (std::size_t i = 0; i < result.values.size() && !trial.log_gain[o].empty(); ++i)
        result.values[i] += trial.log_gain[o][observation.scalar->values[i].channel];
    return result;
}

ExpectedSpectra predict_like(const Predictions& similar, const Trial& trial, const LikelihoodContext& context,
                             std::size_t o, Reuse reuse) {
    return similar.caches.empty() ? predict_one(trial, context, o)
                                  : predict_one(trial, context, o, &similar.caches[o], reuse);
}

Predictions predict(const Trial& trial, const LikelihoodContext& context) {
    const std::vector<Observation>& observations = *context.observations;
    Predictions predictions{std::vector<ExpectedSpectra>(observations.size()),
                            std::vector<ExpectationCache>(observations.size())};
    std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic, 1) num_threads(thread_count(context))
    for (std::size_t o = 0; o < observations.size(); ++o) try {
            predictions.spectra[o] = predict_one(trial, context, o, nullptr, Reuse::nothing, &predictions.caches[o]);
        } catch (...) {
#pragma omp critical(railpem_predict)
            failure = std::current_exception();
        }
    if (failure) std::rethrow_exception(failure);
    return predictions;
}

const Predictions& predictions_of(const Trial& trial, const Predictions& known, const LikelihoodContext& context,
                                  Part part, std::optional<Predictions>& made) {
    const auto differs = [&](const Observation& own) {
        return measured(own, context.part).speeds != measured(own, part).speeds;
    };
    if (part == context.part || std::none_of(context.observations->begin(), context.observations->end(), differs))
        return known;
    LikelihoodContext other = context;
    other.part = part;
    return made.emplace(predict(trial, other));
}

namespace {

/// Of one likelihood, for the count.
void count_likelihood(const LikelihoodContext& context, std::size_t unknowns) {
    if (!context.effort) return;
    for (const Observation& own : *context.observations)
        if (!own.scalar) context.effort->add(effort_of_likelihood(own.bins() / context.every, unknowns));
}

double sum_of(const std::vector<double>& parts) {
    double sum = 0.0;
    for (const double own : parts) sum += own;
    return sum;
}

}  // namespace

double log_likelihood(const Trial& trial, const Predictions& predictions, const LikelihoodContext& context) {
    count_likelihood(context, 0);
    const std::vector<Observation>& observations = *context.observations;
    const std::vector<Chunk> chunks = chunks_of(observations);
    std::vector<double> sums(chunks.size(), 0.0);
#pragma omp parallel for schedule(dynamic, 1) num_threads(thread_count(context))
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        const Chunk& chunk = chunks[i];
        const MeasuredSpectra& data = measured(observations[chunk.observation], context.part);
        WhitenedBin white;
        for (std::size_t bin = chunk.first; bin < chunk.first + chunk.count; bin += context.every) {
            whiten(trial, observations[chunk.observation], chunk.observation, predictions[chunk.observation], data, bin,
                   context.least_floor, known_power(context, chunk.observation, bin), white);
            sums[i] += weight_of(context, data) * white.log_likelihood;
        }
    }
    const double sum = scalar_log_likelihood(trial, predictions, context) + sum_of(sums);
    return std::isfinite(sum) ? sum : -std::numeric_limits<double>::infinity();
}

BinPowers bin_powers(const Trial& trial, const Predictions& predictions, const LikelihoodContext& context) {
    count_likelihood(context, 0);
    const std::vector<Observation>& observations = *context.observations;
    BinPowers powers;
    for (const Observation& observation : observations)
        powers.at.emplace_back(observation.scalar ? 0 : observation.bins());
    const std::vector<Chunk> chunks = chunks_of(observations);
    std::vector<double> sums(chunks.size(), 0.0);
#pragma omp parallel for schedule(dynamic, 1) num_threads(thread_count(context))
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        const std::size_t o = chunks[i].observation;
        const MeasuredSpectra& data = measured(observations[o], context.part);
        WhitenedBin white;
        for (std::size_t bin = chunks[i].first; bin < chunks[i].first + chunks[i].count && !observations[o].scalar;
             bin += context.every) {
            whiten(trial, observations[o], o, predictions[o], data, bin, context.least_floor, nullptr, white);
            powers.at[o][bin] = {white.processes, std::log(white.amplification), white.bend};
            sums[i] += weight_of(context, data) * white.log_likelihood;
        }
    }
    powers.log_likelihood = sum_of(sums);
    return powers;
}

namespace {

std::vector<LikelihoodSlope> chunk_slopes(const std::vector<Chunk>& chunks, const Trial& trial,
                                          const std::vector<Unknown>& unknowns, const Predictions& predictions,
                                          const std::vector<PredictionDerivative>& derivatives,
                                          const LikelihoodContext& context) {
    count_likelihood(context, unknowns.size());
    std::vector<LikelihoodSlope> parts(chunks.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(thread_count(context))
    for (std::size_t i = 0; i < chunks.size(); ++i)
        parts[i] = chunk_slope(chunks[i], trial, unknowns, predictions, derivatives, context);
    return parts;
}

}  // namespace

std::vector<GradientBlock> gradient_blocks(const Trial& trial, const std::vector<Unknown>& unknowns,
                                           const Predictions& predictions,
                                           const std::vector<PredictionDerivative>& derivatives,
                                           const LikelihoodContext& context) {
    const std::vector<Chunk> chunks = chunks_of(*context.observations, kLikelihoodSettings.block_bins());
    const std::vector<LikelihoodSlope> parts = chunk_slopes(chunks, trial, unknowns, predictions, derivatives, context);
    std::vector<GradientBlock> blocks;
    for (std::size_t i = 0; i < chunks.size(); ++i)
        if (!(*context.observations)[chunks[i].observation].scalar)
            blocks.push_back({chunks[i].observation,
                              (*context.observations)[chunks[i].observation].frequency(chunks[i].first),
                              parts[i].gradient});
    return blocks;
}

LikelihoodSlope likelihood_slope(const Trial& trial, const std::vector<Unknown>& unknowns,
                                 const Predictions& predictions, const std::vector<PredictionDerivative>& derivatives,
                                 const LikelihoodContext& context) {
    const std::vector<LikelihoodSlope> parts =
        chunk_slopes(chunks_of(*context.observations), trial, unknowns, predictions, derivatives, context);
    const long count = static_cast<long>(unknowns.size());
    LikelihoodSlope total{.gradient = Eigen::VectorXd::Zero(count), .information = Eigen::MatrixXd::Zero(count, count)};
    for (const LikelihoodSlope& part : parts) {
        total.log_likelihood += part.log_likelihood;
        total.gradient += part.gradient;
        total.information += part.information;
    }
    // Active unknowns of a bin are not in order: both triangles hold parts of the sums.
    const Eigen::MatrixXd sums = total.information;
    total.information = sums + sums.transpose();
    total.information.diagonal() = sums.diagonal();
    add_scalar_slope(trial, unknowns, predictions, derivatives, context, total);
    return total;
}

}  // namespace railpem::diagnosis

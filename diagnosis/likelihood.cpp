#include "diagnosis/likelihood.hpp"

#include <omp.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "diagnosis/predict_scalars.hpp"
#include "diagnosis/scalar_likelihood.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;
constexpr int kMostChannels = 16;
constexpr std::size_t kChunkBins = 64;  ///< bins summed at a time, so that sums do not depend on the threads
using Matrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMostChannels, kMostChannels>;

int thread_count(const LikelihoodContext& context) { return context.threads > 0 ? context.threads : omp_get_max_threads(); }

double floor_of(const Trial& trial, std::size_t response, double frequency, double least) {
    const FloorPlace place = floor_place(frequency);
    const double* node = &trial.floor[static_cast<std::size_t>(floor_group(response) * kFloorNodeCount + place.node)];
    const double own = node[0] > 0.0 && node[1] > 0.0
                           ? std::exp((1.0 - place.share) * std::log(node[0]) + place.share * std::log(node[1]))
                           : (1.0 - place.share) * node[0] + place.share * node[1];
    return own * own + least * least;
}

/// Bins of an observation that are summed together.
struct Chunk {
    std::size_t observation, first, count;
};

std::vector<Chunk> chunks_of(const std::vector<Observation>& observations) {
    std::vector<Chunk> chunks;
    for (std::size_t o = 0; o < observations.size(); ++o)
        for (std::size_t first = 0; first < observations[o].bins(); first += kChunkBins)
            chunks.push_back({o, first, std::min(kChunkBins, observations[o].bins() - first)});
    return chunks;
}

/// One bin, whitened: inverse factor, residual and its share of the log-likelihood per average.
struct WhitenedBin {
    Matrix inverse_factor;
    Matrix residual;
    double log_likelihood = 0.0;
};

WhitenedBin whiten(const Trial& trial, const Observation& observation, std::size_t index,
                   const ExpectedSpectra& prediction, const MeasuredSpectra& data, std::size_t bin, double least_floor) {
    const long size = static_cast<long>(prediction.channels);
    Matrix model = complete_prediction(trial, observation, index, prediction, bin, least_floor);
    const Eigen::LLT<Matrix> factor(model);
    WhitenedBin result;
    if (factor.info() != Eigen::Success) {
        result.log_likelihood = -std::numeric_limits<double>::infinity();
        return result;
    }
    result.inverse_factor = Matrix::Identity(size, size);
    factor.matrixL().solveInPlace(result.inverse_factor);
    const Eigen::Map<const Eigen::MatrixXcd> estimate(&data.values[bin * prediction.channels * prediction.channels], size, size);
    const Matrix half = result.inverse_factor * estimate;
    result.residual = half * result.inverse_factor.adjoint();
    double log_determinant = 0.0;
    for (long i = 0; i < size; ++i) log_determinant -= 2.0 * std::log(result.inverse_factor(i, i).real());
    result.log_likelihood = -(log_determinant - data.log_determinant[bin] + result.residual.trace().real() - static_cast<double>(size));
    result.residual.diagonal().array() -= 1.0;
    return result;
}

/// A Hermitian matrix as a real vector whose dot products are tr(AB).
template <class Source>
void pack(const Source& matrix, double* out) {
    const double root = std::sqrt(2.0);
    for (long column = 0; column < matrix.cols(); ++column) {
        *out++ = matrix(column, column).real();
        for (long row = column + 1; row < matrix.rows(); ++row) {
            *out++ = root * matrix(row, column).real();
            *out++ = root * matrix(row, column).imag();
        }
    }
}

/// The columns of one bin: which unknowns move it and their whitened derivatives.
class BinColumns {
  public:
    BinColumns(std::size_t unknowns, std::size_t size) : columns_(static_cast<long>(size * size), static_cast<long>(unknowns)) {}
    void clear() { active_.clear(); }
    template <class Source>
    void add(int unknown, const Source& whitened) {
        pack(whitened, columns_.col(static_cast<long>(active_.size())).data());
        active_.push_back(unknown);
    }
    void accumulate(double weight, const Eigen::VectorXd& residual, LikelihoodSlope& slope) {
        const long count = static_cast<long>(active_.size());
        const auto block = columns_.leftCols(count);
        product_.setZero(count, count);
        product_.selfadjointView<Eigen::Lower>().rankUpdate(block.transpose(), weight);
        const Eigen::VectorXd gradient = weight * (block.transpose() * residual);
        for (long i = 0; i < count; ++i) {
            slope.gradient(active_[static_cast<std::size_t>(i)]) += gradient(i);
            for (long j = 0; j <= i; ++j)
                slope.information(active_[static_cast<std::size_t>(i)], active_[static_cast<std::size_t>(j)]) += product_(i, j);
        }
    }

  private:
    Eigen::MatrixXd columns_, product_;
    std::vector<int> active_;
};

/// Columns of the noise and of the floor: diagonal derivatives, in closed form.
void add_diagonal_columns(const Trial& trial, const std::vector<Unknown>& unknowns, const Observation& observation,
                          std::size_t index, const ExpectedSpectra& prediction, std::size_t bin,
                          const Matrix& inverse_factor, BinColumns& columns) {
    const FloorPlace place = floor_place(observation.frequency(bin));
    const std::size_t size = prediction.channels;
    const Complex* model = &prediction.values[bin * size * size];
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
        const Unknown& unknown = unknowns[u];
        if (unknown.kind == UnknownKind::noise && unknown.observation == static_cast<int>(index)) {
            const std::size_t c = static_cast<std::size_t>(unknown.index);
            const auto v = inverse_factor.col(static_cast<long>(c));
            columns.add(static_cast<int>(u), Matrix(trial.noise_psd[index][c] * v * v.adjoint()));
        }
        if (unknown.kind != UnknownKind::floor) continue;
        const int group = unknown.index / kFloorNodeCount, node = unknown.index % kFloorNodeCount;
        const double share = node == place.node ? 1.0 - place.share : node == place.node + 1 ? place.share : 0.0;
        if (share == 0.0) continue;
        Matrix sum = Matrix::Zero(static_cast<long>(size), static_cast<long>(size));
        bool any = false;
        for (std::size_t c = 0; c < size; ++c) {
            const std::size_t response = observation.channels[c].response;
            if (floor_group(response) != group) continue;
            const double slope = 2.0 * share * floor_of(trial, response, observation.frequency(bin), 0.0) * model[c * (size + 1)].real();
            const auto v = inverse_factor.col(static_cast<long>(c));
            sum.noalias() += slope * v * v.adjoint();
            any = true;
        }
        if (any) columns.add(static_cast<int>(u), sum);
    }
}

/// The derivatives of the predictions, whitened. The floor grows with the prediction.
void add_prediction_columns(const Trial& trial, const Observation& observation, const std::vector<const PredictionDerivative*>& derivatives,
                            std::size_t size, std::size_t bin, double least_floor, const Matrix& inverse_factor, BinColumns& columns) {
    std::vector<double> floor(size);
    for (std::size_t c = 0; c < size; ++c)
        floor[c] = 1.0 + floor_of(trial, observation.channels[c].response, observation.frequency(bin), least_floor);
    Matrix derivative(static_cast<long>(size), static_cast<long>(size)), half;
    for (const PredictionDerivative* own : derivatives) {
        const Complex* values = &own->values[bin * size * size];
        bool zero = true;
        for (std::size_t c = 0; c < size && zero; ++c) zero = values[c * (size + 1)].real() == 0.0;
        if (zero) continue;
        for (std::size_t i = 0; i < size * size; ++i) derivative.data()[i] = Complex(values[i].real(), values[i].imag());
        for (std::size_t c = 0; c < size; ++c) derivative(static_cast<long>(c), static_cast<long>(c)) *= floor[c];
        half.noalias() = inverse_factor.triangularView<Eigen::Lower>() * derivative;
        columns.add(own->unknown, Matrix(half * inverse_factor.adjoint()));
    }
}

}  // namespace

const MeasuredSpectra& measured(const Observation& observation, Part part) {
    return part == Part::fitted ? observation.fitted : part == Part::held_out ? observation.held_out : observation.all;
}

Eigen::MatrixXcd complete_prediction(const Trial& trial, const Observation& observation, std::size_t index,
                                     const ExpectedSpectra& prediction, std::size_t bin, double least_floor) {
    Eigen::MatrixXcd model = prediction.matrix(bin);
    for (long c = 0; c < model.rows(); ++c) {
        const std::size_t response = observation.channels[static_cast<std::size_t>(c)].response;
        const double floor = floor_of(trial, response, observation.frequency(bin), least_floor);
        model(c, c) = model(c, c).real() * (1.0 + floor) + trial.noise_psd[index][static_cast<std::size_t>(c)];
    }
    return model;
}

ExpectedSpectra predict_one(const Trial& trial, const LikelihoodContext& context, std::size_t o, const ExpectationCache* known, Reuse reuse,
                            ExpectationCache* filled) {
    const Observation& observation = (*context.observations)[o];
    const pem::CaseParameters parameters = case_of(trial, *context.believed, observation);
    if (!observation.scalar)
        return expected_spectra(parameters, trial.speed_m_per_s[o], observation.kernel, observation.channels, {}, observation.expectation, known,
                                reuse, filled);
    ExpectedSpectra result{.values = predict_scalars(parameters, trial.speed_m_per_s[o], observation, known, reuse, filled)};
    for (std::size_t i = 0; i < result.values.size() && !trial.log_gain[o].empty(); ++i)
        result.values[i] += trial.log_gain[o][observation.scalar->values[i].channel];
    return result;
}

Predictions predict(const Trial& trial, const LikelihoodContext& context) {
    const std::vector<Observation>& observations = *context.observations;
    Predictions predictions{std::vector<ExpectedSpectra>(observations.size()), std::vector<ExpectationCache>(observations.size())};
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

std::vector<PredictionDerivative> differentiate(const Trial& trial, const std::vector<Unknown>& unknowns,
                                                const std::vector<double>& values, const Predictions& predictions,
                                                const LikelihoodContext& context) {
    const std::vector<Observation>& observations = *context.observations;
    std::vector<PredictionDerivative> derivatives;
    for (std::size_t u = 0; u < unknowns.size(); ++u)
        for (std::size_t o = 0; o < observations.size(); ++o) {
            if (!moves(unknowns[u], trial, observations[o], o)) continue;
            derivatives.push_back({static_cast<int>(o), static_cast<int>(u), {}});
        }
    std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic, 1) num_threads(thread_count(context))
    for (std::size_t d = 0; d < derivatives.size(); ++d) try {
            PredictionDerivative& own = derivatives[d];
            const std::size_t o = static_cast<std::size_t>(own.observation), u = static_cast<std::size_t>(own.unknown);
            const Unknown& unknown = unknowns[u];
            const double step = values[u] + unknown.step <= unknown.high ? unknown.step : -unknown.step;
            Trial moved = trial;
            unknown.set(moved, values[u] + step);
            const ExpectedSpectra spectra = predict_one(moved, context, o, &predictions.caches[o], shared_with(trial, unknown));
            own.values.resize(spectra.values.size());
            for (std::size_t i = 0; i < spectra.values.size(); ++i)
                own.values[i] = Complex((spectra.values[i] - predictions[o].values[i]) / step);
        } catch (...) {
#pragma omp critical(railpem_predict)
            failure = std::current_exception();
        }
    if (failure) std::rethrow_exception(failure);
    return derivatives;
}

double log_likelihood(const Trial& trial, const Predictions& predictions, const LikelihoodContext& context) {
    const std::vector<Observation>& observations = *context.observations;
    const std::vector<Chunk> chunks = chunks_of(observations);
    std::vector<double> sums(chunks.size(), 0.0);
#pragma omp parallel for schedule(dynamic, 1) num_threads(thread_count(context))
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        const Chunk& chunk = chunks[i];
        const MeasuredSpectra& data = measured(observations[chunk.observation], context.part);
        for (std::size_t bin = chunk.first; bin < chunk.first + chunk.count; ++bin)
            sums[i] += data.averages * whiten(trial, observations[chunk.observation], chunk.observation,
                                              predictions[chunk.observation], data, bin, context.least_floor).log_likelihood;
    }
    double sum = scalar_log_likelihood(trial, predictions, context);
    for (const double own : sums) sum += own;
    return std::isfinite(sum) ? sum : -std::numeric_limits<double>::infinity();
}

LikelihoodSlope likelihood_slope(const Trial& trial, const std::vector<Unknown>& unknowns, const Predictions& predictions,
                                 const std::vector<PredictionDerivative>& derivatives, const LikelihoodContext& context) {
    const std::vector<Observation>& observations = *context.observations;
    const std::vector<Chunk> chunks = chunks_of(observations);
    const long count = static_cast<long>(unknowns.size());
    std::vector<LikelihoodSlope> parts(chunks.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(thread_count(context))
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        const Chunk& chunk = chunks[i];
        const std::size_t o = chunk.observation;
        const Observation& observation = observations[o];
        const MeasuredSpectra& data = measured(observation, context.part);
        const std::size_t size = observation.channels.size();
        std::vector<const PredictionDerivative*> own;
        for (const PredictionDerivative& derivative : derivatives)
            if (derivative.observation == static_cast<int>(o)) own.push_back(&derivative);
        LikelihoodSlope& slope = parts[i];
        slope.gradient = Eigen::VectorXd::Zero(count);
        slope.information = Eigen::MatrixXd::Zero(count, count);
        BinColumns columns(unknowns.size(), size);
        Eigen::VectorXd residual(static_cast<long>(size * size));
        for (std::size_t bin = chunk.first; bin < chunk.first + chunk.count; ++bin) {
            const WhitenedBin white = whiten(trial, observation, o, predictions[o], data, bin, context.least_floor);
            slope.log_likelihood += data.averages * white.log_likelihood;
            if (!std::isfinite(white.log_likelihood)) continue;
            columns.clear();
            add_prediction_columns(trial, observation, own, size, bin, context.least_floor, white.inverse_factor, columns);
            add_diagonal_columns(trial, unknowns, observation, o, predictions[o], bin, white.inverse_factor, columns);
            pack(white.residual, residual.data());
            columns.accumulate(data.averages, residual, slope);
        }
    }
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

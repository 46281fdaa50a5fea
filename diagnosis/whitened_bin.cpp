#include "diagnosis/whitened_bin.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace railpem::diagnosis {

namespace {

constexpr int kSteps = 4;             ///< of Newton's method for s; Fisher's information is nearly exact
constexpr double kLongestStep = 1.0;
constexpr double kNear = 1e-4;        ///< of a step after which another changes nothing
constexpr double kLeastExcess = 1e-6;

/// The parts of S(s).
struct Parts {
    BinMatrix excited;            ///< prediction with floor
    Eigen::Array<double, Eigen::Dynamic, 1, 0, kMostChannels, 1> noise;
};

Parts parts_of(const Trial& trial, const Observation& observation, std::size_t index, const ExpectedSpectra& prediction, std::size_t bin, double least_floor) {
    const long size = static_cast<long>(prediction.channels);
    Parts parts{.excited = complete_prediction(trial, observation, index, prediction, bin, least_floor), .noise = {}};
    parts.noise.resize(size);
    for (long c = 0; c < size; ++c) {
        parts.noise(c) = trial.noise_psd[index][static_cast<std::size_t>(c)];
        parts.excited(c, c) -= parts.noise(c);
    }
    return parts;
}

/// Everything at one s but the projection.
WhitenedBin whiten_at(const Parts& parts, const MeasuredSpectra& data, std::size_t bin, double s) {
    const long size = parts.excited.rows();
    WhitenedBin result{.inverse_factor = {}, .residual = {}, .scale = {}, .amplification = std::exp(s)};
    BinMatrix model = result.amplification * parts.excited;
    model.diagonal().array() += parts.noise.cast<std::complex<double>>();
    const Eigen::LLT<BinMatrix> factor(model);
    if (factor.info() != Eigen::Success) {
        result.log_likelihood = -std::numeric_limits<double>::infinity();
        return result;
    }
    result.inverse_factor = BinMatrix::Identity(size, size);
    factor.matrixL().solveInPlace(result.inverse_factor);
    const Eigen::Map<const Eigen::MatrixXcd> estimate(&data.values[bin * static_cast<std::size_t>(size * size)], size, size);
    const BinMatrix half = result.inverse_factor * estimate;
    result.residual = half * result.inverse_factor.adjoint();
    double log_determinant = 0.0;
    for (long i = 0; i < size; ++i) log_determinant -= 2.0 * std::log(result.inverse_factor(i, i).real());
    result.log_likelihood = -(log_determinant - data.log_determinant[bin] + result.residual.trace().real() - static_cast<double>(size));
    result.residual.diagonal().array() -= 1.0;
    // What is excited is S without noise: L⁻¹(S − N)L⁻ᴴ = 1 − L⁻¹NL⁻ᴴ.
    const BinMatrix damped = result.inverse_factor * parts.noise.cast<std::complex<double>>().matrix().asDiagonal();
    result.scale = -(damped * result.inverse_factor.adjoint());
    result.scale.diagonal().array() += 1.0;
    return result;
}

double trace_of(const BinMatrix& a, const BinMatrix& b) { return a.cwiseProduct(b.conjugate()).sum().real(); }

}  // namespace

double floor_of(const Trial& trial, std::size_t response, double frequency_hz, double least) {
    const FloorPlace place = floor_place(frequency_hz);
    const double* node = &trial.floor[static_cast<std::size_t>(floor_group(response) * kFloorNodeCount + place.node)];
    const double own = node[0] > 0.0 && node[1] > 0.0
                           ? std::exp((1.0 - place.share) * std::log(node[0]) + place.share * std::log(node[1]))
                           : (1.0 - place.share) * node[0] + place.share * node[1];
    return own * own + least * least;
}

WhitenedBin whiten(const Trial& trial, const Observation& observation, std::size_t index, const ExpectedSpectra& prediction,
                   const MeasuredSpectra& data, std::size_t bin, double least_floor) {
    const Parts parts = parts_of(trial, observation, index, prediction, bin, least_floor);
    WhitenedBin best = whiten_at(parts, data, bin, 0.0);
    if (!std::isfinite(best.log_likelihood)) return best;
    const double processes = trace_of(best.scale, best.scale);
    if (processes < 1.0 + kLeastExcess) return best;
    const double stiffness = processes / (processes - 1.0);  // 1/(v·n)
    double s = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double slope = trace_of(best.scale, best.residual) - stiffness * s;
        const double step = std::clamp(slope / (trace_of(best.scale, best.scale) + stiffness), -kLongestStep, kLongestStep);
        WhitenedBin next = whiten_at(parts, data, bin, s + step);
        next.log_likelihood -= 0.5 * stiffness * (s + step) * (s + step);
        if (!(next.log_likelihood > best.log_likelihood)) break;
        s += step;
        best = std::move(next);
        if (std::abs(step) < kNear) break;
    }
    best.projection = 1.0 / (trace_of(best.scale, best.scale) + stiffness);
    return best;
}

}  // namespace railpem::diagnosis

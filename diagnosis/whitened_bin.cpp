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

/// A lower triangular matrix as numbers side by side: columns of real and of imaginary parts.
struct Lower {
    double re[kMostChannels][kMostChannels], im[kMostChannels][kMostChannels];  ///< [column][row]
    explicit Lower(const BinMatrix& matrix) {
        for (long j = 0; j < matrix.cols(); ++j)
            for (long i = j; i < matrix.rows(); ++i) re[j][i] = matrix(i, j).real(), im[j][i] = matrix(i, j).imag();
    }
};

/// L⁻¹HL⁻ᴴ of a Hermitian H, whose entries `h(row, column)` gives. Small matrices: what a general product spends on packing is more than this.
template <class Hermitian>
BinMatrix sandwiched(const Lower& inverse, long size, const Hermitian& h) {
    double re[kMostChannels][kMostChannels], im[kMostChannels][kMostChannels];  // half = L⁻¹H, rows from its diagonal down
    for (long k = 0; k < size; ++k) {
        for (long i = k; i < size; ++i) re[k][i] = im[k][i] = 0.0;
        for (long m = 0; m < size; ++m) {
            const std::complex<double> own = h(m, k);
            const double a = own.real(), b = own.imag();
            for (long i = std::max(m, k); i < size; ++i) {
                re[k][i] += inverse.re[m][i] * a - inverse.im[m][i] * b;
                im[k][i] += inverse.re[m][i] * b + inverse.im[m][i] * a;
            }
        }
    }
    BinMatrix result(size, size);
    for (long j = 0; j < size; ++j) {
        double x[kMostChannels] = {}, y[kMostChannels] = {};
        for (long k = 0; k <= j; ++k) {
            const double a = inverse.re[k][j], b = -inverse.im[k][j];
            for (long i = j; i < size; ++i) {
                x[i] += re[k][i] * a - im[k][i] * b;
                y[i] += re[k][i] * b + im[k][i] * a;
            }
        }
        result(j, j) = x[j];
        for (long i = j + 1; i < size; ++i) {
            result(i, j) = {x[i], y[i]};
            result(j, i) = {x[i], -y[i]};
        }
    }
    return result;
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
    const Lower inverse(result.inverse_factor);
    result.residual = sandwiched(inverse, size, [&](long i, long j) { return estimate(i, j); });
    double log_determinant = 0.0;
    for (long i = 0; i < size; ++i) log_determinant -= 2.0 * std::log(result.inverse_factor(i, i).real());
    result.log_likelihood = -(log_determinant - data.log_determinant[bin] + result.residual.trace().real() - static_cast<double>(size));
    result.residual.diagonal().array() -= 1.0;
    // What is excited is S without noise: L⁻¹(S − N)L⁻ᴴ = 1 − L⁻¹NL⁻ᴴ.
    result.scale.resize(size, size);
    for (long j = 0; j < size; ++j)
        for (long i = j; i < size; ++i) {
            double x = i == j ? 1.0 : 0.0, y = 0.0;
            for (long k = 0; k <= j; ++k) {
                x -= parts.noise(k) * (inverse.re[k][i] * inverse.re[k][j] + inverse.im[k][i] * inverse.im[k][j]);
                y -= parts.noise(k) * (inverse.im[k][i] * inverse.re[k][j] - inverse.re[k][i] * inverse.im[k][j]);
            }
            result.scale(i, j) = {x, y};
            result.scale(j, i) = {x, -y};
        }
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

#include "diagnosis/likelihood/whitened_bin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "diagnosis/likelihood/likelihood_settings.hpp"

namespace railpem::diagnosis {

namespace {

/// The parts of S(s), and what was measured.
struct Parts {
    std::size_t size = 0;
    SplitMatrix excited;   ///< prediction with floor, lower triangle
    SplitMatrix estimate;  ///< in full
    double noise[kMostChannels];
    double log_determinant = 0.0;  ///< of the estimate
};

void split(const std::complex<double>* values, std::size_t size, SplitMatrix& matrix) {
    set_zero(matrix, size);
    for (std::size_t j = 0; j < size; ++j)
        for (std::size_t i = 0; i < size; ++i)
            matrix.re[j][i] = values[j * size + i].real(), matrix.im[j][i] = values[j * size + i].imag();
}

/// The estimate gets the floor's powers too, so that what is measured under a true model still scatters about it: with
/// the floor in the model alone every estimate is far too coherent, Fisher's information is not the curvature, and
/// steps that it proposes overshoot.
void blunt(Parts& parts, double least_floor) {
    for (std::size_t c = 0; c < parts.size; ++c) parts.estimate.re[c][c] *= 1.0 + least_floor * least_floor;
    SplitMatrix lower = parts.estimate;
    const double own = log_determinant(lower, parts.size);
    parts.log_determinant = std::isnan(own) ? 0.0 : own;
}

Parts parts_of(const Trial& trial, const Observation& observation, std::size_t index, const ExpectedSpectra& prediction,
               const MeasuredSpectra& data, std::size_t bin, double least_floor) {
    Parts parts;
    const std::size_t size = parts.size = prediction.channels, first = bin * size * size;
    split(&prediction.values[first], size, parts.excited);
    split(&data.values[first], size, parts.estimate);
    parts.log_determinant = data.log_determinant[bin];
    if (least_floor > 0.0) blunt(parts, least_floor);
    const std::array<double, kFloorGroups> floors = floors_at(trial, observation.frequency(bin), least_floor);
    for (std::size_t c = 0; c < size; ++c) {
        parts.noise[c] = noise_at(trial, index, c, observation.frequency(bin));
        parts.excited.re[c][c] *= 1.0 + floors[floor_group(observation.channels[c].response)];
        parts.excited.im[c][c] = 0.0;
    }
    return parts;
}

/// Everything at one s but the projection.
void whiten_at(const Parts& parts, double s, WhitenedBin& result) {
    const std::size_t size = parts.size, rows = padded_rows(size);
    result.amplification = std::exp(s);
    SplitMatrix model;
    for (std::size_t j = 0; j < size; ++j) {
        for (std::size_t i = 0; i < rows; ++i) {
            model.re[j][i] = result.amplification * parts.excited.re[j][i];
            model.im[j][i] = result.amplification * parts.excited.im[j][i];
        }
        // NOLINT(clang-analyzer-core.uninitialized.Assign): rows are never fewer than the size
        model.re[j][j] += parts.noise[j];
    }
    const double log_determinant = invert_factor(model, size, result.inverse_factor);
    if (std::isnan(log_determinant)) {
        result.log_likelihood = -std::numeric_limits<double>::infinity();
        return;
    }
    sandwich(result.inverse_factor, parts.estimate, size, result.residual);
    sandwich_diagonal(result.inverse_factor, parts.noise, size, result.scale);
    double trace = 0.0;
    for (std::size_t j = 0; j < size; ++j) {
        trace += result.residual.re[j][j];
        result.residual.re[j][j] -= 1.0;
        // What is excited is S without noise: L⁻¹(S − N)L⁻ᴴ = 1 − L⁻¹NL⁻ᴴ.
        for (std::size_t i = j; i < size; ++i) {
            result.scale.re[j][i] = (i == j ? 1.0 : 0.0) - result.scale.re[j][i];
            result.scale.im[j][i] = -result.scale.im[j][i];
        }
    }
    result.log_likelihood = -(log_determinant - parts.log_determinant + trace - static_cast<double>(size));
}

/// The residual of the most probable s, a step `share` further: a thousandth in s, always on the side from which the
/// steps come, is tens of nats in the slopes of all bins together.
void settle_residual(WhitenedBin& bin, double share, std::size_t size) {
    for (std::size_t j = 0; j < size; ++j)
        for (std::size_t i = j; i < size; ++i) {
            bin.residual.re[j][i] -= share * bin.scale.re[j][i];
            bin.residual.im[j][i] -= share * bin.scale.im[j][i];
        }
}

}  // namespace

std::array<double, kFloorGroups> floors_at(const Trial& trial, double frequency_hz, double least) {
    const FloorPlace place = floor_place(frequency_hz);
    std::array<double, kFloorGroups> floors;
    for (std::size_t group = 0; group < floors.size(); ++group) {
        const double* node = &trial.floor[group * kFloorNodeCount + static_cast<std::size_t>(place.node)];
        const double own = node[0] > 0.0 && node[1] > 0.0
                               ? std::exp((1.0 - place.share) * std::log(node[0]) + place.share * std::log(node[1]))
                               : (1.0 - place.share) * node[0] + place.share * node[1];
        floors[group] = own * own + least * least;
    }
    return floors;
}

void whiten(const Trial& trial, const Observation& observation, std::size_t index, const ExpectedSpectra& prediction,
            const MeasuredSpectra& data, std::size_t bin, double least_floor, const BinPower* known,
            WhitenedBin& result) {
    // The first step goes by Fisher's information: far from the top several times the curvature, or a part of it.
    const double longest = kLikelihoodSettings.longest_power_step, shortening = kLikelihoodSettings.power_shortening;
    const Parts parts = parts_of(trial, observation, index, prediction, data, bin, least_floor);
    double s = known ? known->log_amplification : 0.0;
    result.projection = result.bend = 0.0;
    whiten_at(parts, s, result);
    if (!std::isfinite(result.log_likelihood)) return;
    double processes = trace_of_product(result.scale, result.scale, parts.size);
    result.processes = known ? known->processes : processes;
    if (result.processes < 1.0 + kLikelihoodSettings.least_excess) return;
    const double stiffness = result.processes / (result.processes - 1.0);  // 1/(v·n)
    result.log_likelihood -= 0.5 * stiffness * s * s;
    double slope = trace_of_product(result.scale, result.residual, parts.size) - stiffness * s,
           bend = processes + stiffness;
    if (known && known->bend > 0.0) bend = std::clamp(known->bend, bend / shortening, shortening * bend);
    WhitenedBin other;  // of twelve kilobytes: the two take turns
    WhitenedBin *best = &result, *next = &other;
    for (int i = 0; i < kLikelihoodSettings.power_steps; ++i) {
        const double step = std::clamp(slope / bend, -longest, longest);
        if (std::abs(step) < kLikelihoodSettings.least_power_step) break;
        whiten_at(parts, s + step, *next);
        next->log_likelihood -= 0.5 * stiffness * (s + step) * (s + step);
        if (!(next->log_likelihood > best->log_likelihood)) {
            bend *= shortening;
            continue;
        }
        const double there = trace_of_product(next->scale, next->residual, parts.size) - stiffness * (s + step),
                     secant = (slope - there) / step;
        s += step;
        slope = there;
        next->processes = best->processes;
        std::swap(best, next);
        processes = trace_of_product(best->scale, best->scale, parts.size);
        bend = std::clamp(secant, (processes + stiffness) / shortening, shortening * (processes + stiffness));
    }
    best->bend = bend;
    best->projection = 1.0 / (processes + stiffness);
    settle_residual(*best, slope / bend, parts.size);
    if (best != &result) result = *best;
}

}  // namespace railpem::diagnosis

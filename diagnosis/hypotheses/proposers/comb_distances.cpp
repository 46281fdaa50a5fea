#include "diagnosis/hypotheses/proposers/comb_distances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "diagnosis/hypotheses/proposers/comb_relatives.hpp"
#include "diagnosis/likelihood/whitened_bin.hpp"
#include "pem/coupling/excitation.hpp"
#include "spectra/rail_joint_lines.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;

constexpr std::array<double, 3> kLengths_m = {0.2, 0.5, 1.2};
constexpr int kReachBins = 2;        ///< of a Hann window's main lobe
constexpr int kSmoothBins = 6;       ///< either way: what is smoother than this the irregularity takes
constexpr double kSamePlace = 0.02;  ///< relative
constexpr double kShare = 0.5;       ///< of a bin, by which the highest line may be missed

/// What a line in the middle of every bin of one recording would bring.
struct LineScores {
    double speed_m_per_s = 0.0, bin_hz = 0.0, from_hz = 0.0;
    std::array<double, 2 * kReachBins + 1> kernel{};  ///< at whole bins
    std::vector<double> root;      ///< √F, F = n·|u|⁴ without what the free power of the bin takes
    std::vector<double> deviates;  ///< g/√F
};

/// uᴴHu of a Hermitian H, lower triangle given.
double form(const SplitMatrix& h, const std::vector<Complex>& u) {
    double sum = 0.0;
    for (std::size_t j = 0; j < u.size(); ++j) {
        sum += h.re[j][j] * std::norm(u[j]);
        for (std::size_t i = j + 1; i < u.size(); ++i)
            sum += 2.0 * (std::conj(u[i]) * Complex(h.re[j][i], h.im[j][i]) * u[j]).real();
    }
    return sum;
}

LineScores line_scores(const Fit& fit, const LikelihoodContext& context, std::size_t o) {
    const Observation& observation = (*context.observations)[o];
    const MeasuredSpectra& data = measured(observation, context.part);
    const pem::WheelTransfers& transfers = fit.predictions.caches[o].transfers;
    const std::vector<double> wheels = vehicle::wheel_positions(fit.trial.numbers.vehicle);
    LineScores scores{.speed_m_per_s = fit.trial.speed_m_per_s[o],
                      .bin_hz = observation.kernel.bin_hz(),
                      .from_hz = observation.frequency(0)};
    for (long k = -kReachBins; k <= kReachBins; ++k)
        scores.kernel[static_cast<std::size_t>(k + kReachBins)] =
            observation.kernel(static_cast<double>(k) * scores.bin_hz);
    const std::size_t size = observation.channels.size();
    std::vector<Complex> at(size * 4), wave(size), u(size);
    WhitenedBin white;
    for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
        const double frequency = observation.frequency(bin);
        pem::interpolate(transfers, frequency, at.data());
        for (std::size_t c = 0; c < size; ++c) {
            wave[c] = 0.0;
            for (std::size_t j = 0; j < 4; ++j)
                wave[c] += at[c * 4 + j] * pem::delay_phase(wheels, j, frequency, scores.speed_m_per_s);
        }
        whiten(fit.trial, observation, o, fit.predictions[o], data, bin, context.least_floor, nullptr, white);
        double gradient = 0.0, information = 0.0;
        if (std::isfinite(white.log_likelihood)) {
            for (std::size_t i = 0; i < size; ++i) {
                u[i] = 0.0;
                for (std::size_t j = 0; j <= i; ++j)
                    u[i] += Complex(white.inverse_factor.re[j][i], white.inverse_factor.im[j][i]) * wave[j];
            }
            double power = 0.0;
            for (const Complex& value : u) power += std::norm(value);
            const double taken = form(white.scale, u);
            gradient = data.averages * form(white.residual, u);
            information = data.averages * std::max(0.0, power * power - white.projection * taken * taken);
        }
        scores.root.push_back(std::sqrt(information));
        scores.deviates.push_back(information > 0.0 ? gradient / std::sqrt(information) : 0.0);
    }
    return scores;
}

/// Score and information of a comb of unit depth in one recording, smooth parts taken out; `weights` is scratch.
void add_comb(const LineScores& scores, const spectra::RailJoints& joints, std::vector<double>& weights, double& score,
              double& information) {
    const long bins = static_cast<long>(scores.root.size());
    weights.assign(static_cast<std::size_t>(bins), 0.0);
    const double step = scores.speed_m_per_s / joints.spacing_m;
    for (int order = std::max(1, static_cast<int>(scores.from_hz / step));; ++order) {
        const long bin = std::lround((order * step - scores.from_hz) / scores.bin_hz);
        if (bin >= bins) break;
        if (bin < 0) continue;
        const double amplitude = spectra::joint_line_amplitude_m(joints, order);
        for (long k = -kReachBins; k <= kReachBins; ++k)
            if (bin + k >= 0 && bin + k < bins)
                weights[static_cast<std::size_t>(bin + k)] +=
                    0.5 * amplitude * amplitude * scores.kernel[static_cast<std::size_t>(k + kReachBins)];
    }
    for (long b = 0; b < bins; ++b) weights[static_cast<std::size_t>(b)] *= scores.root[static_cast<std::size_t>(b)];
    double sum = 0.0;
    for (long b = 0; b < std::min<long>(bins, kSmoothBins); ++b) sum += weights[static_cast<std::size_t>(b)];
    for (long b = 0; b < bins; ++b) {
        if (b + kSmoothBins < bins) sum += weights[static_cast<std::size_t>(b + kSmoothBins)];
        if (b - kSmoothBins > 0) sum -= weights[static_cast<std::size_t>(b - kSmoothBins - 1)];
        const long count = std::min(bins - 1, b + kSmoothBins) - std::max(0L, b - kSmoothBins) + 1;
        const double own = weights[static_cast<std::size_t>(b)] - sum / static_cast<double>(count);
        score += own * scores.deviates[static_cast<std::size_t>(b)];
        information += own * own;
    }
}

bool is_same(const CombDistance& a, const CombDistance& b) {
    return std::abs(a.spacing_m / b.spacing_m - 1.0) < kSamePlace;
}

}  // namespace

std::vector<CombDistance> comb_distances(const Fit& fit, const LikelihoodContext& context, double shortest_m,
                                         double longest_m, std::size_t most) {
    std::vector<LineScores> recordings;
    double finest = 1.0;
    for (std::size_t o = 0; o < context.observations->size(); ++o) {
        const Observation& observation = (*context.observations)[o];
        if (observation.scalar) continue;
        recordings.push_back(line_scores(fit, context, o));
        finest = std::min(finest, kShare * observation.kernel.bin_hz() / observation.expectation.high_hz);
    }
    std::vector<CombDistance> found;
    std::vector<double> weights;
    for (double spacing = shortest_m; spacing <= longest_m && !recordings.empty(); spacing *= 1.0 + finest) {
        CombDistance best{.spacing_m = spacing};
        for (const double length : kLengths_m) {
            double score = 0.0, information = 0.0;
            for (const LineScores& scores : recordings)
                add_comb(scores, {.spacing_m = spacing, .depth_m = 1e-3, .length_m = length}, weights, score,
                         information);
            const double nats = score > 0.0 && information > 0.0 ? 0.5 * score * score / information : 0.0;
            if (nats > best.nats) best.nats = nats, best.length_m = length;
        }
        if (best.nats > 0.0) found.push_back(best);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const CombDistance& a, const CombDistance& b) { return a.nats > b.nats; });
    std::vector<CombDistance> apart;
    for (const CombDistance& own : found)
        if (apart.size() < most &&
            std::none_of(apart.begin(), apart.end(), [&](const CombDistance& other) { return is_same(own, other); }))
            apart.push_back(own);
    return apart;
}

void add_combs(const Fit& fit, const LikelihoodContext& context, std::vector<Candidate>& candidates) {
    constexpr std::size_t kMost = 4;
    const auto comb_of = [](const Candidate& candidate) -> const EffectParameter* {
        const Effect& effect = *find_effect(candidate.instance.effect);
        const auto comb = std::find_if(effect.parameters.begin(), effect.parameters.end(),
                                       [](const EffectParameter& parameter) { return parameter.comb; });
        return comb != effect.parameters.end() && candidate.instance.values.count(comb->name) ? &*comb : nullptr;
    };
    std::vector<Candidate> added;
    for (const Candidate& candidate : candidates) {
        const EffectParameter* comb = comb_of(candidate);
        const bool first = comb && std::none_of(added.begin(), added.end(), [&](const Candidate& other) {
                               return same_variant(other.instance, candidate.instance);
                           });
        if (!first) continue;
        for (const CombDistance& own : comb_distances(
                 fit, context, comb->low, std::min(comb->high, longest_comb_m(*context.observations)), kMost)) {
            Candidate at = candidate;
            for (EffectInstance* instance : {&at.instance, &at.probe})
                instance->values[comb->name] = own.spacing_m, instance->values["length_m"] = own.length_m;
            added.push_back(std::move(at));
        }
    }
    candidates.insert(candidates.end(), added.begin(), added.end());
}

}  // namespace railpem::diagnosis

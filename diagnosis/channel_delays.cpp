#include "diagnosis/channel_delays.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "diagnosis/likelihood.hpp"
#include "pem/sensor_chain.hpp"
#include "pem/solution.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;

constexpr double kNear = 0.2;          ///< periods at the end of the band: within them a derivative leads
constexpr double kMostWeight = 100.0;  ///< of a phase: beyond it the model's own error counts

/// Agreement of a channel with the others at a bin, its phase that of the channel's delay.
struct Agreement {
    double frequency_hz;
    Complex value;
};

Agreement agreement_at(const Eigen::MatrixXcd& model, const Eigen::MatrixXcd& data, long channel, double frequency_hz) {
    const long others = model.rows() - 1;
    std::vector<long> rest;
    for (long i = 0; i < model.rows(); ++i)
        if (i != channel) rest.push_back(i);
    Eigen::MatrixXcd model_rest(others, others), data_rest(others, others);
    Eigen::VectorXcd model_cross(others), data_cross(others);
    for (long i = 0; i < others; ++i) {
        for (long j = 0; j < others; ++j) model_rest(i, j) = model(rest[i], rest[j]), data_rest(i, j) = data(rest[i], rest[j]);
        model_cross(i) = model(rest[i], channel), data_cross(i) = data(rest[i], channel);
    }
    const Eigen::VectorXcd weights = model_rest.llt().solve(model_cross);  // x̂ = wᴴ·x
    const double said = weights.dot(data_rest * weights).real(), measured = data(channel, channel).real();
    if (!(said > 0.0 && measured > 0.0)) return {frequency_hz, 0.0};
    const Complex coherence = weights.dot(data_cross) / std::sqrt(said * measured);  // of what is said with what is measured
    const double power = std::min(std::norm(coherence), 1.0);
    const double weight = std::min(kMostWeight, power / std::max(1.0 - power, 1e-9));
    return {frequency_hz, power > 0.0 ? coherence / std::sqrt(power) * weight : 0.0};
}

void add_agreements(const Fit& fit, const LikelihoodContext& context, std::size_t o, std::size_t response, std::vector<Agreement>& agreements) {
    const Observation& observation = (*context.observations)[o];
    const MeasuredSpectra& data = measured(observation, context.part);
    const long size = static_cast<long>(observation.channels.size());
    if (observation.scalar || size < 2) return;
    for (long c = 0; c < size; ++c) {
        if (observation.channels[static_cast<std::size_t>(c)].response != response) continue;
        for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
            const Eigen::MatrixXcd own = Eigen::Map<const Eigen::MatrixXcd>(&data.values[bin * static_cast<std::size_t>(size * size)], size, size);
            agreements.push_back(agreement_at(complete_prediction(fit.trial, observation, o, fit.predictions[o], bin, context.least_floor), own, c, observation.frequency(bin)));
        }
    }
}

double highest_hz(const std::vector<Observation>& observations) {
    double highest = 0.0;
    for (const Observation& own : observations)
        if (!own.scalar) highest = std::max(highest, own.expectation.high_hz);
    return highest;
}

/// The response that a channel of the catalogue measures.
std::size_t response_of(const std::string& channel) {
    const auto& names = pem::response_names();
    const std::string where = pem::measured_response(channel);
    return static_cast<std::size_t>(std::find_if(names.begin(), names.end(), [&](const auto& own) { return own.where == where; }) - names.begin());
}

}  // namespace

double channel_delay_s(const Fit& fit, const LikelihoodContext& context, std::size_t response, double longest_s) {
    std::vector<Agreement> agreements;
    for (std::size_t o = 0; o < context.observations->size(); ++o) add_agreements(fit, context, o, response, agreements);
    if (agreements.empty()) return 0.0;
    const double step = 1.0 / (8.0 * highest_hz(*context.observations));
    double best = 0.0, most = 0.0;
    for (int k = -static_cast<int>(longest_s / step); k * step <= longest_s; ++k) {
        double sum = 0.0;
        for (const Agreement& own : agreements) sum += (own.value * std::polar(1.0, -2.0 * std::numbers::pi * own.frequency_hz * k * step)).real();
        if (sum > most) most = sum, best = k * step;
    }
    return best;
}

void add_delays(const Fit& fit, const LikelihoodContext& context, std::vector<Candidate>& candidates) {
    constexpr const char* kDelay = "delay_s";
    const double nearest = highest_hz(*context.observations) > 0.0 ? kNear / highest_hz(*context.observations) : 0.0;
    std::vector<Candidate> added;
    for (const Candidate& candidate : candidates) {
        if (candidate.whole || !candidate.instance.values.count(kDelay) || !candidate.instance.choices.count("channel")) continue;
        const Effect& effect = *find_effect(candidate.instance.effect);
        const auto parameter = std::find_if(effect.parameters.begin(), effect.parameters.end(), [](const EffectParameter& own) { return own.name == kDelay; });
        const double delay = channel_delay_s(fit, context, response_of(candidate.instance.choices.at("channel")), parameter->high);
        if (std::abs(delay) < nearest) continue;
        Candidate late = candidate;
        late.whole = true;
        for (EffectInstance* instance : {&late.instance, &late.probe}) instance->values[kDelay] = delay;
        const auto same = [&](const Candidate& own) { return own.whole && same_variant(own.instance, late.instance) && own.instance.values.at(kDelay) == delay; };
        if (std::none_of(candidates.begin(), candidates.end(), same)) added.push_back(std::move(late));
    }
    candidates.insert(candidates.end(), added.begin(), added.end());
}

}  // namespace railpem::diagnosis

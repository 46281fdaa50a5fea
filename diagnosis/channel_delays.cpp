#include "diagnosis/channel_delays.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

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

using Agreements = std::map<std::size_t, std::vector<Agreement>>;  ///< by response

/// x̂ = wᴴ·x is the most that the other channels say of one: of S⁻¹ its column, −1/P_cc of it and nothing of the channel itself.
Agreement agreement(const Eigen::MatrixXcd& inverse, const Eigen::MatrixXcd& data, long channel, double frequency_hz) {
    Eigen::VectorXcd weights = -inverse.col(channel) / inverse(channel, channel).real();
    weights(channel) = 0.0;
    const Eigen::VectorXcd seen = data * weights;
    const double said = weights.dot(seen).real(), measured = data(channel, channel).real();
    if (!(said > 0.0 && measured > 0.0)) return {frequency_hz, 0.0};
    const Complex coherence = weights.dot(data.col(channel)) / std::sqrt(said * measured);  // of what is said with what is measured
    const double power = std::min(std::norm(coherence), 1.0);
    const double weight = std::min(kMostWeight, power / std::max(1.0 - power, 1e-9));
    return {frequency_hz, power > 0.0 ? coherence / std::sqrt(power) * weight : 0.0};
}

void add_agreements(const Fit& fit, const LikelihoodContext& context, std::size_t o, Agreements& agreements) {
    const Observation& observation = (*context.observations)[o];
    const MeasuredSpectra& data = measured(observation, context.part);
    const long size = static_cast<long>(observation.channels.size());
    if (observation.scalar || size < 2) return;
    const Eigen::MatrixXcd identity = Eigen::MatrixXcd::Identity(size, size);
    for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
        const Eigen::MatrixXcd own = Eigen::Map<const Eigen::MatrixXcd>(&data.values[bin * static_cast<std::size_t>(size * size)], size, size);
        const Eigen::MatrixXcd inverse = complete_prediction(fit.trial, observation, o, fit.predictions[o], bin, context.least_floor).llt().solve(identity);
        for (long c = 0; c < size; ++c)
            agreements[observation.channels[static_cast<std::size_t>(c)].response].push_back(agreement(inverse, own, c, observation.frequency(bin)));
    }
}

Agreements agreements_of(const Fit& fit, const LikelihoodContext& context) {
    Agreements agreements;
    for (std::size_t o = 0; o < context.observations->size(); ++o) add_agreements(fit, context, o, agreements);
    return agreements;
}

/// Where the sum of the real parts, turned back, is largest.
double best_delay_s(const std::vector<Agreement>& agreements, double step_s, double longest_s) {
    const int reach = static_cast<int>(longest_s / step_s);
    std::vector<double> sums(static_cast<std::size_t>(2 * reach + 1));
    for (const Agreement& own : agreements) {
        Complex turned = own.value * std::polar(1.0, 2.0 * std::numbers::pi * own.frequency_hz * reach * step_s);
        const Complex turn = std::polar(1.0, -2.0 * std::numbers::pi * own.frequency_hz * step_s);
        for (double& sum : sums) sum += turned.real(), turned *= turn;
    }
    const auto best = std::max_element(sums.begin(), sums.end());
    return *best > 0.0 ? static_cast<double>(best - sums.begin() - reach) * step_s : 0.0;
}

double highest_hz(const std::vector<Observation>& observations) {
    double highest = 0.0;
    for (const Observation& own : observations)
        if (!own.scalar) highest = std::max(highest, own.expectation.high_hz);
    return highest;
}

double scan_step_s(const std::vector<Observation>& observations) { return 1.0 / (8.0 * highest_hz(observations)); }

}  // namespace

double channel_delay_s(const Fit& fit, const LikelihoodContext& context, std::size_t response, double longest_s) {
    const Agreements all = agreements_of(fit, context);
    const auto own = all.find(response);
    return own == all.end() ? 0.0 : best_delay_s(own->second, scan_step_s(*context.observations), longest_s);
}

void add_delays(const Fit& fit, const LikelihoodContext& context, std::vector<Candidate>& candidates) {
    constexpr const char* kDelay = "delay_s";
    const double nearest = highest_hz(*context.observations) > 0.0 ? kNear / highest_hz(*context.observations) : 0.0;
    const Agreements all = agreements_of(fit, context);
    std::vector<Candidate> added;
    for (const Candidate& candidate : candidates) {
        if (candidate.whole || !candidate.instance.values.count(kDelay) || !candidate.instance.choices.count("channel")) continue;
        const Effect& effect = *find_effect(candidate.instance.effect);
        const auto parameter = std::find_if(effect.parameters.begin(), effect.parameters.end(), [](const EffectParameter& own) { return own.name == kDelay; });
        const auto heard = all.find(pem::response_index(pem::measured_response(candidate.instance.choices.at("channel"))));
        const double delay = heard == all.end() ? 0.0 : best_delay_s(heard->second, scan_step_s(*context.observations), parameter->high);
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

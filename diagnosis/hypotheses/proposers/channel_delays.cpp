#include "diagnosis/hypotheses/proposers/channel_delays.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include "diagnosis/hypotheses/said_by_others.hpp"
#include "pem/response_names.hpp"

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

Agreement agreement(const SaidByOthers& own) {
    if (!(own.said > 0.0 && own.measured > 0.0)) return {own.frequency_hz, 0.0};
    const Complex coherence = own.cross / std::sqrt(own.said * own.measured);
    const double power = std::min(std::norm(coherence), 1.0);
    const double weight = std::min(kMostWeight, power / std::max(1.0 - power, 1e-9));
    return {own.frequency_hz, power > 0.0 ? coherence / std::sqrt(power) * weight : 0.0};
}

Agreements agreements_of(const Fit& fit, const LikelihoodContext& context) {
    Agreements agreements;
    for_each_said_by_others(fit, context,
                            [&](const SaidByOthers& own) { agreements[own.response].push_back(agreement(own)); });
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

double scan_step_s(const std::vector<Observation>& observations) {
    return 1.0 / (8.0 * highest_hz(observations));
}

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
        if (candidate.whole || !candidate.instance.values.count(kDelay) || !candidate.instance.choices.count("channel"))
            continue;
        const Effect& effect = *find_effect(candidate.instance.effect);
        const auto parameter = std::find_if(effect.parameters.begin(), effect.parameters.end(),
                                            [](const EffectParameter& own) { return own.name == kDelay; });
        const auto heard =
            all.find(pem::response_index(pem::measured_response(candidate.instance.choices.at("channel"))));
        const double delay =
            heard == all.end() ? 0.0 : best_delay_s(heard->second, scan_step_s(*context.observations), parameter->high);
        if (std::abs(delay) < nearest) continue;
        Candidate late = candidate;
        late.whole = true;
        for (EffectInstance* instance : {&late.instance, &late.probe}) instance->values[kDelay] = delay;
        const auto same = [&](const Candidate& own) {
            return own.whole && same_variant(own.instance, late.instance) && own.instance.values.at(kDelay) == delay;
        };
        if (std::none_of(candidates.begin(), candidates.end(), same)) added.push_back(std::move(late));
    }
    candidates.insert(candidates.end(), added.begin(), added.end());
}

}  // namespace railpem::diagnosis

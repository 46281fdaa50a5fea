#include "diagnosis/hypotheses/proposers/channel_resonances.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

#include "diagnosis/hypotheses/said_by_others.hpp"
#include "pem/response_names.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;

/// below, the grid of the catalogue leads there: its peak is an octave wide
constexpr double kLeastAmplification = 2.0;
constexpr const char* kFrequency = "frequency_hz";
constexpr const char* kDamping = "damping_ratio";

/// What a channel measured against what the others say of it, at one frequency.
struct Transfer {
    Complex cross = 0.0;
    double said = 0.0;
};

using Transfers = std::map<double, Transfer>;          ///< by frequency, over all recordings
using TransfersOf = std::map<std::size_t, Transfers>;  ///< by response

/// In units of what the fit expects, so that no recording drowns the others.
TransfersOf transfers_of(const Fit& fit, const LikelihoodContext& context) {
    TransfersOf transfers;
    for_each_said_by_others(fit, context, [&](const SaidByOthers& own) {
        Transfer& sum = transfers[own.response][own.frequency_hz];
        sum.cross += own.cross / own.expected;
        sum.said += own.said / own.expected;
    });
    return transfers;
}

std::optional<ChannelResonance> peak_of(const Transfers& transfers) {
    double most = kLeastAmplification;
    std::optional<ChannelResonance> found;
    for (const auto& [frequency, own] : transfers) {
        const double amplification = own.said > 0.0 ? std::abs(own.cross) / own.said : 0.0;
        if (amplification <= most) continue;
        most = amplification;
        found = ChannelResonance{frequency, 0.5 / amplification};
    }
    return found;
}

const EffectParameter& parameter_named(const Effect& effect, const char* name) {
    return *std::find_if(effect.parameters.begin(), effect.parameters.end(),
                         [&](const EffectParameter& own) { return own.name == name; });
}

}  // namespace

std::optional<ChannelResonance> channel_resonance(const Fit& fit, const LikelihoodContext& context,
                                                  std::size_t response) {
    const TransfersOf all = transfers_of(fit, context);
    const auto own = all.find(response);
    return own == all.end() ? std::nullopt : peak_of(own->second);
}

void add_resonances(const Fit& fit, const LikelihoodContext& context, std::vector<Candidate>& candidates) {
    const TransfersOf all = transfers_of(fit, context);
    std::map<std::string, Candidate> added;  // one a channel
    for (const Candidate& candidate : candidates) {
        const auto& choices = candidate.instance.choices;
        if (!candidate.instance.values.count(kFrequency) || !choices.count("channel") ||
            added.count(choices.at("channel")))
            continue;
        const auto heard = all.find(pem::response_index(pem::measured_response(choices.at("channel"))));
        const std::optional<ChannelResonance> peak = heard == all.end() ? std::nullopt : peak_of(heard->second);
        const Effect& effect = *find_effect(candidate.instance.effect);
        if (!peak || peak->frequency_hz < parameter_named(effect, kFrequency).low) continue;
        const EffectParameter& damping = parameter_named(effect, kDamping);
        Candidate sharp = candidate;
        for (EffectInstance* instance : {&sharp.instance, &sharp.probe}) {
            instance->values[kFrequency] = peak->frequency_hz;
            instance->values[kDamping] = std::clamp(peak->damping_ratio, damping.low, damping.high);
        }
        sharp.whole = true;
        sharp.read_off = true;  // of a peak this high half a bin aside the first order asks for a hundredth
        const auto same = [&](const Candidate& own) {
            return same_variant(own.instance, sharp.instance) &&
                   own.instance.values.at(kFrequency) == peak->frequency_hz;
        };
        if (std::none_of(candidates.begin(), candidates.end(), same))
            added.emplace(choices.at("channel"), std::move(sharp));
    }
    for (auto& [channel, own] : added) candidates.push_back(std::move(own));
}

}  // namespace railpem::diagnosis

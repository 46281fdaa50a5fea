#include "app/prove/trial_result.hpp"

#include <algorithm>
#include <cmath>

namespace railpem::app {

namespace {

constexpr double kLeastProbability = 1e-6;  ///< sets below it are not kept

ClaimedSet claimed_set(const diagnosis::Rival& rival) {
    ClaimedSet set{.probability = rival.probability};
    for (const diagnosis::EffectInstance& instance : rival.instances) {
        ClaimedEffect claimed{.effect = instance.effect, .choices = instance.choices};
        if (const auto key = instance.choices.find("parameter"); key != instance.choices.end())
            claimed.element = element_name(diagnosis::element_of_key(key->second));
        else if (const diagnosis::Effect* effect = diagnosis::find_effect(instance.effect))
            claimed.element = element_name(diagnosis::element_of(*effect, instance));
        set.effects.push_back(std::move(claimed));
    }
    return set;
}

/// Variants of the same effects (another channel, another starting value) are one set here.
std::vector<diagnosis::EffectSet> by_identifiers(const std::vector<diagnosis::EffectSet>& posterior) {
    std::map<std::vector<std::string>, double> sums;
    for (const diagnosis::EffectSet& set : posterior) {
        std::vector<std::string> ids = set.effects;
        std::sort(ids.begin(), ids.end());
        sums[ids] += set.probability;
    }
    std::vector<diagnosis::EffectSet> sets;
    for (const auto& [ids, probability] : sums)
        if (probability >= kLeastProbability) sets.push_back({ids, probability});
    std::stable_sort(sets.begin(), sets.end(),
                     [](const auto& a, const auto& b) { return a.probability > b.probability; });
    return sets;
}

/// Fitted parameters of the best set.
std::size_t freedom_of(const diagnosis::Diagnosis& diagnosis) {
    std::size_t count = 0;
    for (const diagnosis::NamedEffect& effect : diagnosis.omitted) count += effect.parameters.size();
    if (count > 0 || diagnosis.rivals.empty()) return count;
    for (const diagnosis::EffectInstance& instance : diagnosis.rivals.front().instances)
        count += instance.values.size();
    return count;
}

}  // namespace

double bic_gain_of_psds(const diagnosis::Diagnosis& diagnosis) {
    double gain = 0.0, values = 0.0;
    for (const diagnosis::ChannelComparison& channel : diagnosis.channels) {
        const auto used =
            std::find_if(diagnosis.recordings.begin(), diagnosis.recordings.end(),
                         [&](const diagnosis::UsedRecording& own) { return own.name == channel.recording; });
        if (used == diagnosis.recordings.end()) continue;
        for (std::size_t i = 0; i < channel.measured.size(); ++i) {
            // A mean of n periodograms is gamma distributed: log L = −n·(ln m + s/m) + const.
            const double s = channel.measured[i], diagnosed = channel.diagnosed[i],
                         retuned = diagnosis.freely_retuned ? diagnosed : channel.retuned[i];
            gain += used->averages * (std::log(retuned / diagnosed) + s / retuned - s / diagnosed);
            values += 1.0;
        }
    }
    return values > 0.0 ? 2.0 * gain - static_cast<double>(freedom_of(diagnosis)) * std::log(values) : 0.0;
}

TrialResult trial_result(std::size_t trial, const diagnosis::Diagnosis& diagnosis) {
    TrialResult result{.trial = trial, .verdict = verdict_name(diagnosis.verdict)};
    for (const diagnosis::NamedEffect& named : diagnosis.omitted)
        result.omitted.push_back({named.instance.effect, named.instance.choices, element_name(named.element),
                                  named.probability, named.parameters});
    if (diagnosis.verdict == diagnosis::Verdict::ambiguous)
        for (const diagnosis::Rival& rival : diagnosis.rivals) result.rivals.push_back(claimed_set(rival));
    result.posterior = by_identifiers(diagnosis.posterior);
    for (const diagnosis::PlaceEvidence& place : diagnosis.places)
        result.places.emplace_back(element_name(place.element), place.probability);
    result.before = diagnosis.before;
    result.retuned = diagnosis.retuned;
    result.after = diagnosis.after;
    result.held_out_before = diagnosis.held_out_before;
    result.held_out_retuned = diagnosis.held_out_retuned;
    result.held_out_after = diagnosis.held_out_after;
    result.hidden_by_retuning = diagnosis.hidden_by_retuning;
    if (const auto& freely = diagnosis.freely_retuned) {
        result.retuned = freely->fitted;
        result.held_out_retuned = freely->held_out;
    }
    for (const diagnosis::RetunedNumber& number : diagnosis.retuned_numbers)
        if (number.outside) result.retuned_outside.push_back(number.key);
    for (const diagnosis::RetunedNumber& number : diagnosis.numbers)
        result.numbers.push_back({number.key, number.value, number.low, number.high});
    result.bic_gain = bic_gain_of_psds(diagnosis);
    result.seconds_diagnosed = diagnosis.seconds_taken;
    return result;
}

}  // namespace railpem::app

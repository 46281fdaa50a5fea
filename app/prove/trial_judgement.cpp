#include "app/prove/trial_judgement.hpp"

#include <algorithm>
#include <cmath>

#include "effects/catalogue.hpp"

namespace railpem::app {

namespace {

/// What tells instances of one effect apart. A choice that may be left away is no more than a value.
std::vector<std::string> telling_choices(const effects::EffectDescription& effect) {
    std::vector<std::string> names;
    for (const effects::EffectChoice& choice : effect.choices)
        if (choice.required) names.push_back(choice.name);
    return names;
}

std::string with_choices(const std::string& id, const std::vector<std::string>& choices) {
    std::string text;
    for (const std::string& choice : choices) text += (text.empty() ? "" : ", ") + choice;
    return text.empty() ? id : id + " (" + text + ")";
}

bool is_sensor(const std::string& id) {
    const diagnosis::Effect* effect = diagnosis::find_effect(id);
    return effect && !effect->elements.empty() && effect->elements.front() == diagnosis::Element::sensor;
}

std::vector<std::string> labels(const std::vector<ClaimedEffect>& effects) {
    std::vector<std::string> list;
    for (const ClaimedEffect& effect : effects) list.push_back(label_of(effect));
    std::sort(list.begin(), list.end());
    return list;
}

std::vector<std::string> labels(const TrialTruth& truth) {
    std::vector<std::string> list;
    for (const simulate::Hidden& hidden : truth.hidden) list.push_back(label_of(hidden));
    std::sort(list.begin(), list.end());
    return list;
}

Claim claim_of(const TrialResult& result) {
    if (!result.failure.empty()) return Claim::failed;
    if (result.verdict == "consistent") return Claim::nothing;
    if (result.verdict == "ambiguous") return Claim::several_sets;
    return result.verdict == "unexplained" ? Claim::no_name : Claim::one_set;
}

std::vector<std::vector<std::string>> returned_sets(const TrialResult& result, Claim claim) {
    std::vector<std::vector<std::string>> sets;
    if (claim == Claim::nothing) sets.push_back({});
    if (claim == Claim::one_set) sets.push_back(labels(result.omitted));
    if (claim == Claim::several_sets)
        for (const ClaimedSet& set : result.rivals) sets.push_back(labels(set.effects));
    std::sort(sets.begin(), sets.end());  // the same effects from two starts are one set to whoever reads
    sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
    return sets;
}

void judge_names(const TrialTruth& truth, const TrialResult& result, Judgement& judgement) {
    const std::vector<std::string> hidden = labels(truth);
    const auto sets = returned_sets(result, judgement.claim);
    judgement.sets_returned = sets.size();
    judgement.truth_returned =
        truth.kind != TrialKind::outside && std::find(sets.begin(), sets.end(), hidden) != sets.end();
    if (judgement.claim != Claim::one_set) return;
    judgement.right_effect = judgement.missing && judgement.truth_returned;
    for (const std::string& name : sets.front())
        ++(std::find(hidden.begin(), hidden.end(), name) != hidden.end() ? judgement.right_names
                                                                         : judgement.wrong_names);
    const auto hidden_sensor = [](const simulate::Hidden& own) { return is_sensor(own.id); };
    const auto claimed_sensor = [](const ClaimedEffect& own) { return is_sensor(own.effect); };
    const bool any_sensor = std::any_of(truth.hidden.begin(), truth.hidden.end(), hidden_sensor);
    const bool only_sensors = judgement.missing && std::all_of(truth.hidden.begin(), truth.hidden.end(), hidden_sensor);
    judgement.sensor_for_physics =
        judgement.missing && !any_sensor && std::any_of(result.omitted.begin(), result.omitted.end(), claimed_sensor);
    judgement.physics_for_sensor =
        only_sensors && !std::all_of(result.omitted.begin(), result.omitted.end(), claimed_sensor);
}

void judge_intervals(const TrialTruth& truth, const TrialResult& result, Judgement& judgement) {
    if (judgement.right_effect)
        for (const ClaimedEffect& claimed : result.omitted) {
            const auto key = claimed.choices.find("parameter");
            for (const diagnosis::FittedParameter& p : claimed.parameters) {
                const double value =
                    true_value(truth, claimed.effect, key == claimed.choices.end() ? "" : key->second, p.name);
                if (std::isfinite(value)) judgement.parameters.count(p.low <= value && value <= p.high);
            }
        }
    if (!judgement.right_effect && !(judgement.claim == Claim::nothing && !judgement.missing)) return;
    for (const ClaimedNumber& number : result.numbers)
        for (const TrueNumber& own : truth.numbers)
            if (own.key == number.key) judgement.numbers.count(number.low <= own.truth && own.truth <= number.high);
}

std::string wrong_with(const TrialTruth& truth, const Judgement& judgement) {
    if (judgement.claim == Claim::failed) return "failed";
    if (!judgement.missing)
        return judgement.claim == Claim::nothing   ? ""
               : judgement.claim == Claim::no_name ? "unexplained although nothing is missing"
                                                   : "named although nothing is missing";
    if (judgement.claim == Claim::nothing) return "missed";
    if (judgement.sensor_for_physics) return "sensor named for physics";
    if (judgement.physics_for_sensor) return "physics named for a sensor";
    if (truth.kind == TrialKind::outside) {
        if (judgement.claim == Claim::one_set) return "confident name for what the catalogue does not have";
        return judgement.right_place ? "" : "wrong place";
    }
    if (judgement.claim == Claim::no_name) return judgement.right_place ? "place without its name" : "wrong place";
    if (judgement.claim == Claim::several_sets) return judgement.truth_returned ? "" : "truth not among the rivals";
    if (judgement.right_effect) return judgement.right_place ? "" : "wrong place";
    if (judgement.wrong_names > 0)
        return judgement.right_names > 0 ? "a wrong name beside a right one" : "wrong effect";
    return "only one of two named";
}

std::string row_of(const TrialTruth& truth) {
    return truth.hidden.empty() ? "nothing" : truth.hidden.size() > 1 ? "pair" : truth.hidden.front().id;
}

std::string column_of(const TrialResult& result, Claim claim) {
    switch (claim) {
        case Claim::failed:
            return "failed";
        case Claim::nothing:
            return "nothing";
        case Claim::several_sets:
            return "ambiguous";
        case Claim::no_name:
            return "unexplained";
        case Claim::one_set:
            return result.omitted.size() == 1 ? result.omitted.front().effect : "several";
    }
    return {};
}

}  // namespace

std::string label_of(const ClaimedEffect& claimed) {
    const effects::EffectDescription* effect = effects::find_description(claimed.effect);
    std::vector<std::string> choices;
    for (const auto& [name, value] : claimed.choices)
        if (!effect) choices.push_back(value);
    if (effect)
        for (const std::string& name : telling_choices(*effect))
            if (const auto found = claimed.choices.find(name); found != claimed.choices.end())
                choices.push_back(found->second);
    return with_choices(claimed.effect, choices);
}

std::string label_of(const simulate::Hidden& hidden) {
    std::vector<std::string> choices;
    for (const std::string& name : telling_choices(*effects::find_description(hidden.id))) {
        if (const auto text = hidden.values.texts.find(name); text != hidden.values.texts.end())
            choices.push_back(text->second);
        if (const auto value = hidden.values.numbers.find(name); value != hidden.values.numbers.end())
            choices.push_back(std::to_string(std::lround(value->second)));
    }
    return with_choices(hidden.id, choices);
}

Judgement judge(const TrialTruth& truth, const TrialResult& result) {
    Judgement judgement{.missing = !truth.hidden.empty(), .claim = claim_of(result)};
    judgement.hidden = row_of(truth);
    judgement.returned = column_of(result, judgement.claim);
    if (judgement.claim != Claim::failed) {
        judgement.concealed = judgement.missing && result.retuned.rms_db < kConcealed_db;
        const std::vector<std::string> places = true_places(truth);
        judgement.right_place = judgement.claim != Claim::nothing && !result.places.empty() &&
                                std::find(places.begin(), places.end(), result.places.front().first) != places.end();
        judge_names(truth, result, judgement);
        judge_intervals(truth, result, judgement);
        if (judgement.right_effect) {
            judgement.misfit_retuned = -result.held_out_retuned.log_likelihood_per_second;
            judgement.misfit_after = -result.held_out_after.log_likelihood_per_second;
        }
        judgement.baseline_retuning = !result.retuned_outside.empty()         ? effects::wrong_number_id()
                                      : result.retuned.rms_db < kConcealed_db ? "consistent"
                                                                              : "misfit";
        judgement.baseline_bic = result.bic_gain > 0.0 ? "best set" : "consistent";
    }
    judgement.wrong = wrong_with(truth, judgement);
    return judgement;
}

}  // namespace railpem::app

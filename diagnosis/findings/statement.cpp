#include "diagnosis/findings/statement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace railpem::diagnosis {

namespace {

std::string named_in_words(const Diagnosis& diagnosis) {
    std::vector<std::string> parts;
    for (const NamedEffect& effect : diagnosis.omitted) {
        std::vector<std::string> values;
        for (const auto& [name, value] : effect.instance.choices) values.push_back(fmt::format("{} {}", name, value));
        for (const FittedParameter& parameter : effect.parameters)
            values.push_back(fmt::format("{} {:.3g}{} [{:.3g}, {:.3g}]", parameter.name, parameter.value,
                                         parameter.unit == "1" ? "" : " " + parameter.unit, parameter.low,
                                         parameter.high));
        parts.push_back(fmt::format("{} ({})", effect.says, fmt::join(values, ", ")));
    }
    return fmt::format("{}", fmt::join(parts, "; and "));
}

std::vector<std::string> in_words(std::vector<std::string> effects) {
    std::replace(effects.begin(), effects.end(), std::string("unknown"), std::string("something there without a name"));
    return effects;
}

std::string place_in_words(const Diagnosis& diagnosis) {
    if (diagnosis.places.empty()) return "no place stands out";
    // A place that the case does not have, ground below rigid supports, has no free correction.
    const PlaceEvidence& named = diagnosis.places.front();
    const auto fewer = [](const PlaceEvidence& a, const PlaceEvidence& b) { return a.nats < b.nats; };
    const PlaceEvidence& most = *std::max_element(diagnosis.places.begin(), diagnosis.places.end(), fewer);
    const PlaceEvidence& place = named.nats > 0.0 ? named : most;
    const std::string forces =
        !place.forces              ? ""
        : place.resonance_hz > 0.0 ? fmt::format(
                                         ", by what each wheel meets by itself, which resonates near {:.0f} Hz: pads "
                                         "have no mass, ground that changes along the line has",
                                         place.resonance_hz)
        : place.element == Element::pad
            ? ", by what each wheel meets by itself, as of seats that are not alike, a play or ground that changes "
              "along the line"
            : ", by forces of its own, as of a stop, a play or a stick, rather than by another stiffness or damping";
    // A promise is made where the retuned case stands; fits from there may say otherwise.
    if (most.nats > place.nats)
        return fmt::format(
            "the most probable place is the {} ({:.0f} nats{}); to the retuned case a free correction of the {} "
            "promises more ({:.0f} nats)",
            element_name(place.element), place.nats, forces, element_name(most.element), most.nats);
    const std::string first =
        &place == &named ? ""
                         : fmt::format("as far as it has a name it sits at the {}, and ", element_name(named.element));
    return fmt::format("{}the place where a free correction helps most is the {} ({:.0f} nats{})", first,
                       element_name(place.element), place.nats, forces);
}

/// With a capital letter.
std::string beginning(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    return text;
}

bool names_only_numbers(const Diagnosis& diagnosis) {
    return std::all_of(diagnosis.omitted.begin(), diagnosis.omitted.end(),
                       [](const NamedEffect& own) { return is_wrong_number(own.instance); });
}

std::string how_far(const std::vector<RetunedNumber>& numbers) {
    const auto nearer = [](const RetunedNumber& a, const RetunedNumber& b) {
        return std::abs(a.tolerances_away) < std::abs(b.tolerances_away);
    };
    const auto furthest = std::max_element(numbers.begin(), numbers.end(), nearer);
    if (furthest == numbers.end() || !furthest->outside) return "within their tolerances";
    return fmt::format("(the furthest, {}, by {:.1f} tolerances)", furthest->key, std::abs(furthest->tolerances_away));
}

}  // namespace

std::string statement_of(const Diagnosis& diagnosis) {
    const std::string gain = fmt::format(
        "With it the recordings are more probable than after retuning {} by {:.3g} nats per {}, and what no fit has "
        "seen by {:.3g}.{}",
        diagnosis.freely_retuned ? "that keeps what is given up within two tolerances" : "alone",
        diagnosis.after.log_likelihood_per_second - diagnosis.retuned.log_likelihood_per_second,
        diagnosis.per_value ? "value" : "second of record",
        diagnosis.held_out_after.log_likelihood_per_second - diagnosis.held_out_retuned.log_likelihood_per_second,
        diagnosis.freely_retuned ? " Retuning that may leave the belief for what that costs goes there, too." : "");
    switch (diagnosis.verdict) {
        case Verdict::consistent:
            return fmt::format(
                "Nothing significant is missing: with its own numbers retuned {} the case explains the recordings "
                "(third octaves within {:.2f} dB rms). No effect of the catalogue and no free correction improves on "
                "it beyond chance.",
                how_far(diagnosis.retuned_numbers), diagnosis.retuned.rms_db);
        case Verdict::explained:
            if (names_only_numbers(diagnosis)) return fmt::format("{}. {}", beginning(named_in_words(diagnosis)), gain);
            return fmt::format("What the case left out: {}. {}", named_in_words(diagnosis), gain);
        case Verdict::recording_fault:
            return fmt::format("The recording is at fault, not the physics: {}. {}", named_in_words(diagnosis), gain);
        case Verdict::ambiguous: {
            std::vector<std::string> sets;
            for (const Rival& rival : diagnosis.rivals)
                sets.push_back(fmt::format("{} ({:.0f} %)", fmt::join(in_words(rival.effects), " with "),
                                           100.0 * rival.probability));
            return fmt::format(
                "Something is missing, and these cannot be told apart with what was recorded: {}. What would decide: "
                "{}.",
                fmt::join(sets, ", or "), diagnosis.rivals.empty() ? "" : diagnosis.rivals.front().would_separate);
        }
        case Verdict::unexplained:
            return fmt::format(
                "Something is missing that no known effect explains: {}.{}", place_in_words(diagnosis),
                diagnosis.omitted.empty() ? "" : fmt::format(" Beside it: {}.", named_in_words(diagnosis)));
    }
    return {};
}

std::string values_in_words(const EffectInstance& instance) {
    std::vector<std::string> values;
    for (const EffectParameter& parameter : find_effect(instance.effect)->parameters)
        if (const auto own = instance.values.find(parameter.name); own != instance.values.end())
            values.push_back(fmt::format("{} {:.3g}", parameter.name, own->second));
    for (const auto& [name, value] : instance.choices) values.push_back(fmt::format("{} {}", name, value));
    return fmt::format("{}", fmt::join(values, ", "));
}

}  // namespace railpem::diagnosis

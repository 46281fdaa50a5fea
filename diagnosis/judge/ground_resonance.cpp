#include "diagnosis/judge/ground_resonance.hpp"

#include <algorithm>

namespace railpem::diagnosis {

namespace {

constexpr double kFalls = 3.0;

/// Behind the pads, with what helps there; in the place of what the support had by itself.
void add_ground(std::vector<PlaceEvidence>& ranked, double resonance_hz) {
    std::erase_if(ranked, [](const PlaceEvidence& own) { return own.element == Element::support; });
    const auto pad = std::find_if(ranked.begin(), ranked.end(),
                                  [](const PlaceEvidence& own) { return own.element == Element::pad; });
    const double nats = pad == ranked.end() ? 0.0 : pad->nats;
    ranked.insert(pad == ranked.end() ? pad : pad + 1,
                  {.element = Element::support, .nats = nats, .forces = true, .resonance_hz = resonance_hz});
}

}  // namespace

std::optional<double> resonance_of(const pem::WheelsOwn& own) {
    const std::vector<double>& share = own.share;
    const std::size_t most = static_cast<std::size_t>(std::max_element(share.begin(), share.end()) - share.begin());
    if (share.size() < 3 || most == 0 || most + 1 == share.size()) return std::nullopt;
    const auto has_fallen = [&](std::size_t node) { return kFalls * share[node] <= share[most]; };
    const bool left = has_fallen(most - 1), right = has_fallen(most + 1);
    const bool left_of_two = most >= 2 && has_fallen(most - 2),
               right_of_two = most + 2 < share.size() && has_fallen(most + 2);
    if ((left && right) || (left && right_of_two) || (left_of_two && right)) return own.frequency_hz[most];
    return std::nullopt;
}

void tell_ground_from_pads(PlaceStudy& study) {
    for (FittedSet& set : study.anonymous) {
        CorrectionPlace& place = set.anonymous.front();
        if (place.element != Element::pad || !place.forces) continue;
        const std::optional<double> resonance = resonance_of(set.fit.trial.numbers.modifiers.wheels_own);
        if (!resonance) continue;
        place.element = Element::support;
        add_ground(study.at_retuned, *resonance);
    }
}

}  // namespace railpem::diagnosis

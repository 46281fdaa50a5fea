#include "diagnosis/findings/say_spoiled.hpp"

#include <fmt/format.h>

#include <cmath>

namespace railpem::diagnosis {

namespace {

NamedEffect as_gain(const SpoiledChannel& slip) {
    NamedEffect named{
        .instance = wrong_gain(slip.channel, slip.factor), .element = Element::sensor, .probability = 1.0};
    named.says = slip.says;
    named.source = find_effect(named.instance.effect)->source;
    named.parameters.push_back(
        {.name = "gain", .value = slip.factor, .low = slip.factor, .high = slip.factor, .unit = "1"});
    return named;
}

}  // namespace

void say_spoiled(const std::vector<SpoiledChannel>& spoiled, Diagnosis& result) {
    if (spoiled.empty()) return;
    std::string slips;
    std::vector<NamedEffect> omitted;
    for (const SpoiledChannel& slip : spoiled) {
        slips += fmt::format("{}{}; as recorded it is {:.1f} dB off, so read {:.1f} dB", slips.empty() ? "" : "; ",
                             slip.says, slip.off_db, slip.left_db);
        if (slip.factor != 1.0) omitted.push_back(as_gain(slip));
    }
    result.statement =
        fmt::format("The recording is at fault, not the physics: {}. With that undone: {}", slips, result.statement);
    result.verdict = Verdict::recording_fault;
    EffectSet said{.effects = {}, .probability = 1.0};
    for (const NamedEffect& own : omitted) said.effects.push_back(own.instance.effect);
    result.omitted = std::move(omitted);
    result.rivals.clear();
    result.posterior = {std::move(said)};
    result.places = {{.element = Element::sensor, .probability = 1.0}};
}

}  // namespace railpem::diagnosis

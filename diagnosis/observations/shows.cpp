#include "diagnosis/observations/shows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace railpem::diagnosis {

using recordings::RecordingKind;

bool reaches(const Observation& observation, Element element) {
    if (!observation.scalar || !observation.scalar->of_track()) return true;
    return element == Element::rail || element == Element::pad || element == Element::support;
}

bool could_show(const Observation& observation, const Effect& effect) {
    if (!observation.scalar) return true;
    const bool reached = std::any_of(effect.elements.begin(), effect.elements.end(),
                                     [&](Element element) { return reaches(observation, element); });
    if (!reached) return false;
    if (observation.scalar->of_track()) return !effect.needs_train;
    if (effect.needs_time_series) return false;
    return observation.scalar->kind == RecordingKind::psd || !effect.needs_lines;
}

std::vector<std::string> scalar_basis(const std::vector<Observation>& observations) {
    std::vector<std::string> basis;
    for (const Observation& observation : observations) {
        if (!observation.scalar) continue;
        const auto held = std::count_if(observation.scalar->values.begin(), observation.scalar->values.end(),
                                        [](const ScalarValue& value) { return value.held_out; });
        basis.push_back(
            fmt::format("{} values of {} in {}, {} of them seen by no fit; their logarithms are compared, with a "
                        "discrepancy that is fitted",
                        observation.scalar->values.size(), kind_in_words(observation), observation.name, held));
        for (const std::string& lack : observation.scalar->lacks) basis.push_back(observation.name + ": " + lack);
    }
    return basis;
}

std::string kind_in_words(const Observation& observation) {
    if (!observation.scalar) return "time series";
    switch (observation.scalar->kind) {
        case RecordingKind::psd:
            return "spectra";
        case RecordingKind::points:
            return "quoted points";
        case RecordingKind::receptance:
            return "receptance";
        case RecordingKind::decay_rate:
            return "decay rate";
        case RecordingKind::timeseries:
            break;
    }
    return "time series";
}

}  // namespace railpem::diagnosis

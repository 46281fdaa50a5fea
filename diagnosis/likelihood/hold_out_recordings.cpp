#include "diagnosis/likelihood/hold_out_recordings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "diagnosis/likelihood/scalar_likelihood.hpp"

namespace railpem::diagnosis {

namespace {

/// As many values of a cell as the fitted or the held-out recordings have share its discrepancy.
void share(std::vector<Observation>& observations, const std::vector<std::size_t>& group) {
    std::map<std::pair<bool, long>, double> cells;
    const auto cell = [](const ScalarValue& value) {
        return std::pair(value.held_out, discrepancy_cell(value.frequency_hz));
    };
    for (const std::size_t o : group)
        for (const ScalarValue& value : observations[o].scalar->values) cells[cell(value)] += 1.0;
    for (const std::size_t o : group)
        for (ScalarValue& value : observations[o].scalar->values) value.sharing = cells[cell(value)];
}

}  // namespace

void hold_out_recordings(std::vector<Observation>& observations) {
    std::map<std::pair<recordings::RecordingKind, recordings::Place>, std::vector<std::size_t>> groups;
    for (std::size_t o = 0; o < observations.size(); ++o)
        if (observations[o].scalar && observations[o].scalar->of_track())
            groups[{observations[o].scalar->kind, observations[o].scalar->place}].push_back(o);
    for (const auto& [kind, group] : groups) {
        if (group.size() < 2) continue;
        const auto held =
            std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(kObservationSettings.held_out_share *
                                                                          static_cast<double>(group.size()))));
        for (std::size_t i = 0; i < group.size(); ++i) {
            ScalarData& data = *observations[group[i]].scalar;
            data.leader = group.front();
            for (ScalarValue& value : data.values) value.held_out = i + held >= group.size();
        }
        share(observations, group);
    }
}

double unseen_share(const std::vector<Observation>& observations) {
    double fitted = 0.0, unseen = 0.0;
    for (const Observation& observation : observations)
        fitted += observation.fitted.seconds, unseen += observation.held_out.seconds;
    if (fitted > 0.0) return unseen / fitted;
    const auto values = static_cast<double>(scalar_count(observations, Part::fitted));
    return values > 0.0 ? static_cast<double>(scalar_count(observations, Part::held_out)) / values : 0.0;
}

}  // namespace railpem::diagnosis

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recordings/checks/checks.hpp"
#include "recordings/checks/level_mistake.hpp"
#include "recordings/checks/median.hpp"
#include "recordings/checks/prediction_levels.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings::checks {
namespace {

/// "a factor 1000 too low: numbers in m taken for mm", "not acceleration: its integral in time …"
std::string mistake_words(const LevelMistake& mistake, const ChannelDescription& channel) {
    if (mistake.derivatives != 0)
        return fmt::format("the channel is not {}, most likely it is {}", quantity_name(channel.quantity),
                           mistake.says);
    const double factor = mistake.factor > 1.0 ? mistake.factor : 1.0 / mistake.factor;
    return fmt::format("most likely a factor {:.4g} too {}: {}", factor, mistake.factor > 1.0 ? "high" : "low",
                       mistake.says);
}

Fault wrong_unit(std::vector<std::string> channels, const LevelMistake& mistake, std::string says) {
    Fault found;
    found.kind = FaultKind::wrong_unit;
    found.severity = Severity::error;
    found.channels = std::move(channels);
    found.says = std::move(says);
    found.value = mistake.factor;
    found.unit = "1";
    found.false_alarm = mistake.probability_none;
    return found;
}

bool told(const std::vector<Fault>& faults, FaultKind kind, const std::string& channel) {
    return std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) {
        return fault.kind == kind &&
               std::find(fault.channels.begin(), fault.channels.end(), channel) != fault.channels.end();
    });
}

/// All channels with one and the same mistake, which is told once.
struct Alike {
    LevelMistake mistake;
    ChannelDescription first;
    std::vector<std::string> channels;
    double least_db = 1e300, most_db = -1e300;
};

/// Every channel against what the case predicts for it.
void check_predicted_levels(const Evidence& evidence, std::vector<Fault>& faults) {
    std::vector<Alike> groups;
    for (std::size_t i = 0; i < evidence.spectra->size(); ++i) {
        const ChannelDescription& channel = evidence.spectra->channels[i];
        if (channel.scale != Scale::known || told(faults, FaultKind::band_limited, channel.name)) continue;
        const auto mistake = level_mistake(against_prediction(evidence, i));
        if (!mistake) continue;
        auto group = std::find_if(groups.begin(), groups.end(), [&](const Alike& other) {
            return other.mistake.says == mistake->says && other.first.quantity == channel.quantity;
        });
        if (group == groups.end()) group = groups.insert(groups.end(), Alike{*mistake, channel, {}});
        group->channels.push_back(channel.name);
        group->least_db = std::min(group->least_db, mistake->level_db);
        group->most_db = std::max(group->most_db, mistake->level_db);
    }
    for (const Alike& group : groups)
        faults.push_back(wrong_unit(
            group.channels, group.mistake,
            fmt::format(
                "{} dB {} what the case predicts: {}",
                group.channels.size() == 1
                    ? fmt::format("{:.1f}", std::abs(group.least_db))
                    : fmt::format("{:.1f} to {:.1f}", std::min(std::abs(group.least_db), std::abs(group.most_db)),
                                  std::max(std::abs(group.least_db), std::abs(group.most_db))),
                group.most_db > 0.0 ? "above" : "below", mistake_words(group.mistake, group.first))));
}

/// Level of one channel over another, per line.
LevelDifferences between(const CrossSpectra& spectra, std::size_t i, std::size_t j) {
    LevelDifferences differences;
    for (std::size_t k = 1; k < spectra.bins(); ++k)
        if (spectra.frequency_hz[k] > 1.0 && spectra.frequency_hz[k] < 0.3 * spectra.sampling_rate_hz &&
            spectra.psd(k, i) > 0.0 && spectra.psd(k, j) > 0.0) {
            differences.frequency_hz.push_back(spectra.frequency_hz[k]);
            differences.level_db.push_back(10.0 * std::log10(spectra.psd(k, i) / spectra.psd(k, j)));
            differences.strong.push_back(true);
        }
    return differences;
}

/// The channels that are at a like place, with the differences of one channel from each.
std::vector<std::pair<std::size_t, LevelDifferences>> like_channels(const CrossSpectra& spectra, std::size_t i) {
    const ChannelDescription& channel = spectra.channels[i];
    constexpr std::size_t kFewest = 8;  // lines
    std::vector<std::pair<std::size_t, LevelDifferences>> found;
    for (std::size_t j = 0; j < spectra.size(); ++j) {
        const ChannelDescription& other = spectra.channels[j];
        if (j == i || other.location != channel.location || other.quantity != channel.quantity) continue;
        if (channel.location == Location::body &&
            std::abs(std::abs(other.position_m) - std::abs(channel.position_m)) > 1.0)
            continue;
        LevelDifferences differences = between(spectra, i, j);
        if (differences.level_db.size() >= kFewest) found.emplace_back(j, std::move(differences));
    }
    return found;
}

/// Per line the median over the other channels, so that one that is wrong itself does not count.
LevelDifferences middle_of(const std::vector<std::pair<std::size_t, LevelDifferences>>& against) {
    LevelDifferences middle = against.front().second;
    for (const auto& [other, differences] : against)
        if (differences.level_db.size() != middle.level_db.size()) return middle;
    for (std::size_t k = 0; k < middle.level_db.size(); ++k) {
        std::vector<double> values;
        for (const auto& [other, differences] : against) values.push_back(differences.level_db[k]);
        middle.level_db[k] = median(values);
    }
    return middle;
}

/// Channels at the same kind of place differ by a few dB, not by 20 or 60, and by as much at all frequencies.
void among_channels(const Evidence& evidence, std::vector<Fault>& faults) {
    const CrossSpectra& spectra = *evidence.spectra;
    for (std::size_t i = 0; i < spectra.size(); ++i) {
        const ChannelDescription& channel = spectra.channels[i];
        if (channel.location == Location::none || told(faults, FaultKind::wrong_unit, channel.name) ||
            told(faults, FaultKind::band_limited, channel.name))
            continue;
        const auto against = like_channels(spectra, i);
        if (against.empty()) continue;
        const auto mistake = level_mistake(middle_of(against));
        const std::string& other = spectra.channels[against.front().first].name;
        // With one other channel it cannot be told which is wrong: said once, of the louder one.
        if (!mistake ||
            (against.size() == 1 && (mistake->level_db < 0.0 || told(faults, FaultKind::wrong_unit, other))))
            continue;
        if (against.size() > 1)
            faults.push_back(wrong_unit({channel.name}, *mistake,
                                        fmt::format("{:+.1f} dB against the other channels at such places: {}",
                                                    mistake->level_db, mistake_words(*mistake, channel))));
        else
            faults.push_back(wrong_unit(
                {channel.name, other}, *mistake,
                fmt::format("{} is {:.1f} dB above {}: one of the two has a unit wrong by a factor {:.4g}, or is "
                            "another quantity",
                            channel.name, mistake->level_db, other, mistake->factor)));
    }
}

}  // namespace

void check_unit(const Evidence& evidence, std::vector<Fault>& faults) {
    const auto is_said = [&](const std::string& name) {
        const auto& said = evidence.recording.contradictions;
        return std::any_of(said.begin(), said.end(), [&](const Fault& fault) {
            return fault.kind == FaultKind::unknown_scale &&
                   std::find(fault.channels.begin(), fault.channels.end(), name) != fault.channels.end();
        });
    };
    for (const Channel& channel : evidence.series().channels)
        if (channel.description.scale == Scale::unknown && !is_said(channel.description.name)) {
            Fault found;
            found.kind = FaultKind::unknown_scale;
            found.severity = Severity::note;
            found.channels = {channel.description.name};
            found.says =
                "the scale is stated to be unknown: shapes, ratios and frequencies can be judged, levels cannot";
            faults.push_back(std::move(found));
        }
    if (!evidence.spectra) return;
    check_predicted_levels(evidence, faults);
    among_channels(evidence, faults);
}

}  // namespace railpem::recordings::checks

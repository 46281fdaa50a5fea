#include "recordings/checks/consequences.hpp"

#include <algorithm>
#include <array>

namespace railpem::recordings::checks {
namespace {

/// A kind of fault that looks like another as well, in the same channels or, from the whole record, in all.
struct Consequence {
    FaultKind cause, looks_like;
};

constexpr std::array<Consequence, 13> consequences = {{
    {FaultKind::stop, FaultKind::low_frequency_noise},  // a level that steps has all slow frequencies in it
    {FaultKind::stop, FaultKind::not_stationary},
    {FaultKind::stop, FaultKind::impacts},    // the first wave after standing still
    {FaultKind::stop, FaultKind::mains_hum},  // a line of the sensors that only rest lets show is no hum of the record
    {FaultKind::speed_changes, FaultKind::not_stationary},
    {FaultKind::duplicated, FaultKind::timing_skew},  // a copy has no delay
    {FaultKind::duplicated, FaultKind::clock_drift},
    {FaultKind::coarse_resolution, FaultKind::impacts},    // a step is an impact to what predicts between steps
    {FaultKind::clipping, FaultKind::impacts},             // so is the edge at which a channel is cut
    {FaultKind::band_limited, FaultKind::not_stationary},  // what is left above the filter is no vibration
    {FaultKind::band_limited, FaultKind::impacts},
    {FaultKind::wrong_unit, FaultKind::timing_skew},  // an integral has another phase
    {FaultKind::wrong_unit, FaultKind::inverted},     // a displacement is against its acceleration
}};

bool shares_channel(const Fault& a, const Fault& b) {
    return std::any_of(a.channels.begin(), a.channels.end(), [&](const std::string& name) {
        return std::find(b.channels.begin(), b.channels.end(), name) != b.channels.end();
    });
}

/// A change of speed that leaves spectra as of one speed does not explain a change of level.
bool is_cause(const Fault& fault) {
    return fault.kind != FaultKind::speed_changes || fault.severity == Severity::error;
}

bool follows(const Fault& fault, const std::vector<Fault>& faults) {
    for (const Consequence& pair : consequences) {
        if (pair.looks_like != fault.kind) continue;
        for (const Fault& cause : faults)
            if (cause.kind == pair.cause && is_cause(cause) && (cause.channels.empty() || shares_channel(cause, fault)))
                return true;
    }
    return false;
}

bool has_wrong_unit(const std::vector<Fault>& faults, const std::string& channel) {
    return std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) {
        return fault.kind == FaultKind::wrong_unit &&
               std::find(fault.channels.begin(), fault.channels.end(), channel) != fault.channels.end();
    });
}

/// A wheel or bogie exchanged with a quieter place makes one channel too loud and the other too quiet; a wrong unit
/// makes one channel look like another place.
void settle_exchanged_places(std::vector<Fault>& faults) {
    for (std::size_t i = 0; i < faults.size(); ++i) {
        // Of a size: told by roughness. An exchange of like channels has none.
        if (faults[i].kind != FaultKind::swapped || faults[i].channels.size() != 2 || faults[i].value <= 0.0) continue;
        const std::vector<std::string> pair = faults[i].channels;
        const bool first = has_wrong_unit(faults, pair[0]), second = has_wrong_unit(faults, pair[1]);
        if (!first && !second) continue;
        if (!first || !second) {
            faults.erase(faults.begin() + static_cast<std::ptrdiff_t>(i--));
            continue;
        }
        const auto is_exchanged = [&](const std::string& name) { return name == pair[0] || name == pair[1]; };
        // Of two channels one is wrong: where one of them is exchanged, nothing is left to tell of the other.
        std::erase_if(faults, [&](const Fault& fault) {
            return fault.kind == FaultKind::wrong_unit && fault.channels.size() <= 2 &&
                   std::any_of(fault.channels.begin(), fault.channels.end(), is_exchanged);
        });
        for (Fault& fault : faults)
            if (fault.kind == FaultKind::wrong_unit) std::erase_if(fault.channels, is_exchanged);
        return settle_exchanged_places(faults);
    }
}

}  // namespace

void drop_consequences(std::vector<Fault>& faults) {
    const std::vector<Fault> all = faults;
    std::erase_if(faults, [&](const Fault& fault) { return follows(fault, all); });
    settle_exchanged_places(faults);
}

}  // namespace railpem::recordings::checks

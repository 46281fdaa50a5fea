#include "diagnosis/model/wheel_unloading.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pem/distortion/contact_distortion.hpp"

namespace railpem::diagnosis {

namespace {

/// Of the static load, rms: 4.5 deviations to nothing, where one of four wheels lifts about once in two minutes (Rice's
/// rate at 60 Hz, 60·e^(−4.5²/2) a second). At 0.25 it is every ten seconds, and a free correction finds 594 nats of it
/// at 0.247 beside the right name; of sixty trials of a full proof the six above 0.25 were wrong (docs/proof).
constexpr double kMost = 0.22;

bool is_of_vehicle(const Observation& observation) {
    return !observation.scalar && observation.speed_m_per_s > 0.0;
}

bool is_unloaded(const Observation& observation) {
    return is_of_vehicle(observation) && observation.expectation.contacts.force_variation > kMost;
}

}  // namespace

std::vector<std::string> wheel_unloading(const Trial& trial, const BelievedCase& believed,
                                         const std::vector<Observation>& observations) {
    std::vector<std::string> said;
    for (const Observation& observation : observations) {
        if (!is_of_vehicle(observation)) continue;
        const double variation =
            pem::contact_force_variation(case_of(trial, believed, observation), observation.speed_m_per_s);
        if (variation > kMost)
            said.push_back(fmt::format(
                "{}: the contact forces vary by {:.0f} % of the static load (rms), so that wheels leave the rail now "
                "and then; what that does is not in the expectation, a slower run would do without",
                observation.name, 100.0 * variation));
    }
    return said;
}

std::vector<std::string> leave_out_unloaded(std::vector<Observation>& observations) {
    std::vector<std::string> said;
    if (std::none_of(observations.begin(), observations.end(),
                     [](const Observation& own) { return is_of_vehicle(own) && !is_unloaded(own); }))
        return said;
    for (const Observation& own : observations)
        if (is_unloaded(own))
            said.push_back(
                fmt::format("{}: left out: the contact forces vary by {:.0f} % of the static load (rms), so that "
                            "wheels leave the rail, which the expectation does not describe",
                            own.name, 100.0 * own.expectation.contacts.force_variation));
    std::erase_if(observations, is_unloaded);
    return said;
}

}  // namespace railpem::diagnosis

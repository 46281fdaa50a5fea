#include "diagnosis/wheel_unloading.hpp"

#include <fmt/format.h>

#include "pem/contact_distortion.hpp"

namespace railpem::diagnosis {

std::vector<std::string> wheel_unloading(const Trial& trial, const BelievedCase& believed, const std::vector<Observation>& observations) {
    constexpr double kMost = 0.25;  // four deviations to nothing: of sixty trials of the full proof the six above it were wrong (docs/proof)
    std::vector<std::string> said;
    for (const Observation& observation : observations) {
        if (observation.scalar || observation.speed_m_per_s <= 0.0) continue;
        const double variation = pem::contact_force_variation(case_of(trial, believed, observation), observation.speed_m_per_s);
        if (variation > kMost)
            said.push_back(fmt::format("{}: the contact forces vary by {:.0f} % of the static load (rms), so that wheels leave the rail now and then; what that does is not in the expectation, a slower run would do without",
                                       observation.name, 100.0 * variation));
    }
    return said;
}

}  // namespace railpem::diagnosis

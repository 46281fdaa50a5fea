#include "diagnosis/judge/repeated_levels.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "diagnosis/judge/compare_channels.hpp"

namespace railpem::diagnosis {

double repeated_level_db(const Fit& fit, const std::vector<Observation>& observations) {
    const Stages same{&fit.trial, &fit.predictions, &fit.trial, &fit.predictions, &fit.trial, &fit.predictions};
    const std::vector<ChannelComparison> seen = compare_channels(same, observations, Part::fitted),
                                         unseen = compare_channels(same, observations, Part::held_out);
    const auto is_series = [&](const std::string& name) {
        return std::any_of(observations.begin(), observations.end(),
                           [&](const Observation& own) { return !own.scalar && own.name == name; });
    };
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t c = 0; c < std::min(seen.size(), unseen.size()); ++c) {
        if (!is_series(seen[c].recording)) continue;
        for (std::size_t band = 0;
             band < std::min(seen[c].band_diagnosed_db.size(), unseen[c].band_diagnosed_db.size()); ++band) {
            const double product = seen[c].band_diagnosed_db[band] * unseen[c].band_diagnosed_db[band];
            if (std::isfinite(product)) sum += product, ++count;
        }
    }
    return count == 0 ? 0.0 : std::sqrt(std::max(0.0, sum / static_cast<double>(count)));
}

}  // namespace railpem::diagnosis

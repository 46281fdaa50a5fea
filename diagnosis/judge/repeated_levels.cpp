#include "diagnosis/judge/repeated_levels.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "diagnosis/judge/compare_channels.hpp"

namespace railpem::diagnosis {

namespace {

std::vector<ChannelComparison> levels_of(const Fit& fit, const LikelihoodContext& context, Part part) {
    std::optional<Predictions> made;
    const Predictions& own = predictions_of(fit.trial, fit.predictions, context, part, made);
    return compare_channels({&fit.trial, &own, &fit.trial, &own, &fit.trial, &own}, *context.observations, part);
}

}  // namespace

double repeated_level_db(const Fit& fit, const LikelihoodContext& context) {
    const std::vector<Observation>& observations = *context.observations;
    const std::vector<ChannelComparison> seen = levels_of(fit, context, Part::fitted),
                                         unseen = levels_of(fit, context, Part::held_out);
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

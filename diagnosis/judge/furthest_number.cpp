#include "diagnosis/judge/furthest_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace railpem::diagnosis {

namespace {

/// A number's distance from its belief, and what a common scale of e would make of it; both in tolerances.
struct Distance {
    double away, by_scale;
};

/// Whether a number of every part is uncertain: what is known exactly pins the scale.
bool is_free(const FittedSet& set) {
    constexpr std::array<const char*, 3> kParts{"vehicle.", "track.", "contact."};
    return std::all_of(kParts.begin(), kParts.end(), [&](const char* part) {
        return std::any_of(set.fit.unknowns.begin(), set.fit.unknowns.end(), [&](const Unknown& own) {
            return own.kind == UnknownKind::number && own.name.starts_with(part);
        });
    });
}

std::vector<Distance> distances(const FittedSet& set) {
    const double scale = is_free(set) ? 1.0 : 0.0;
    std::vector<Distance> distances;
    for (std::size_t u = 0; u < set.fit.unknowns.size(); ++u) {
        const Unknown& own = set.fit.unknowns[u];
        const bool released = std::find(set.released.begin(), set.released.end(), own.name) != set.released.end();
        if (own.kind == UnknownKind::number && !released)
            distances.push_back(
                {(set.fit.values[u] - own.mean) / own.deviation, scale * power_of_scale(own.nature) / own.deviation});
    }
    return distances;
}

}  // namespace

double power_of_scale(parameters::Nature nature) {
    switch (nature) {
        case parameters::Nature::mass:
        case parameters::Nature::inertia:
        case parameters::Nature::section:
        case parameters::Nature::stiffness:
        case parameters::Nature::damping:
            return 1.0;
        case parameters::Nature::contact:
            return -2.0 / 3.0;
        case parameters::Nature::loss:
        case parameters::Nature::other:
            break;
    }
    return 0.0;
}

// Least squares over the others, each by its tolerance: a number that is off is not to move the scale that it is held
// against.
double furthest_number(const FittedSet& set) {
    const std::vector<Distance> all = distances(set);
    double product = 0.0, square = 0.0, furthest = 0.0;
    for (const Distance& own : all) product += own.away * own.by_scale, square += own.by_scale * own.by_scale;
    for (const Distance& own : all) {
        const double others = square - own.by_scale * own.by_scale;
        const double scale = others > 0.0 ? (product - own.away * own.by_scale) / others : 0.0;
        furthest = std::max(furthest, std::abs(own.away - scale * own.by_scale));
    }
    return furthest;
}

}  // namespace railpem::diagnosis

#include "simulate/march/line_faults.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate/numerics/random_numbers.hpp"

namespace railpem::simulate {

namespace {

using std::numbers::pi;

constexpr std::uint64_t for_dips = 321;  // purpose of a derived seed

/// Number of events by inversion of the Poisson distribution.
int poisson(double mean, double uniform) {
    double probability = std::exp(-mean);
    double sum = probability;
    int count = 0;
    while (uniform > sum && probability > 1e-18) {
        probability *= mean / ++count;
        sum += probability;
    }
    return count;
}

}  // namespace

std::vector<Dip> draw_dips(const WorldParameters& world, std::uint64_t line_seed, double from_m, double to_m) {
    constexpr double cell_m = 100.0;
    const std::uint64_t seed = derived_seed(line_seed, for_dips);
    std::vector<Dip> dips;
    for (auto cell = static_cast<std::int64_t>(std::floor(from_m / cell_m)); static_cast<double>(cell) * cell_m <= to_m;
         ++cell) {
        const std::uint64_t own = derived_seed(seed, static_cast<std::uint64_t>(cell));
        const int count = poisson(world.impacts_per_km * cell_m / 1000.0, uniform_at(own, 0));
        for (int i = 0; i < count; ++i) {
            const auto at = 3 * static_cast<std::uint64_t>(i) + 1;
            const Dip dip{.position_m = cell_m * (static_cast<double>(cell) + uniform_at(own, at)),
                          .depth_m = world.impact_depth_m * (0.5 + uniform_at(own, at + 1)),
                          .length_m = world.impact_length_m * (0.7 + 0.6 * uniform_at(own, at + 2))};
            if (dip.position_m >= from_m && dip.position_m <= to_m) dips.push_back(dip);
        }
    }
    std::sort(dips.begin(), dips.end(), [](const Dip& a, const Dip& b) { return a.position_m < b.position_m; });
    return dips;
}

double longest_m(const std::vector<Dip>& dips) {
    double longest = 0.0;
    for (const Dip& dip : dips) longest = std::max(longest, dip.length_m);
    return longest;
}

double height_of_dips(const std::vector<Dip>& dips, double longest_m, double position_m) {
    const auto first = std::lower_bound(dips.begin(), dips.end(), position_m - 0.5 * longest_m,
                                        [](const Dip& dip, double position) { return dip.position_m < position; });
    double height = 0.0;
    for (auto dip = first; dip != dips.end() && dip->position_m < position_m + 0.5 * longest_m; ++dip) {
        const double along = (position_m - dip->position_m) / dip->length_m;
        if (std::abs(along) < 0.5) height -= 0.5 * dip->depth_m * (1.0 + std::cos(2.0 * pi * along));
    }
    return height;
}

void roughen(Profile& profile, double from_m, double to_m, double level_db) {
    const double gain = std::pow(10.0, level_db / 20.0);
    const double fade = std::max(profile.step_m, std::min(10.0, 0.25 * (to_m - from_m)));
    const auto count = static_cast<std::ptrdiff_t>(profile.height_m.size());
    const auto first = static_cast<std::ptrdiff_t>(std::ceil((from_m - profile.first_m) / profile.step_m));
    const auto last = static_cast<std::ptrdiff_t>(std::floor((to_m - profile.first_m) / profile.step_m));
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, first); i <= std::min(last, count - 1); ++i) {
        const double place = profile.first_m + profile.step_m * static_cast<double>(i);
        const double depth = std::clamp(std::min(place - from_m, to_m - place) / fade, 0.0, 1.0);
        const double blend = 0.5 * (1.0 - std::cos(pi * depth));
        profile.height_m[static_cast<std::size_t>(i)] *= 1.0 + (gain - 1.0) * blend;
    }
}

}  // namespace railpem::simulate

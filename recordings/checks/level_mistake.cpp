#include "recordings/checks/level_mistake.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "recordings/checks/median.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings::checks {
namespace {

/// How far a sound case or a like channel may be off in level, dB, one standard deviation.
constexpr double level_scatter_db = 4.0;
/// Share of recordings whose unit is right, whose unit is wrong, and whose quantity is another, before looking.
constexpr double prior_right = 0.75, prior_unit = 0.2, prior_quantity = 0.05;
/// Beyond, nothing is explained: two and a half standard deviations.
constexpr double farthest_db = 10.0;

struct Candidate {
    double factor;
    int derivatives;
    const char* says;
};

constexpr std::array<Candidate, 6> units = {{{standard_gravity_m_per_s2, 0, "numbers in m/s^2 taken for g"},
                                             {1.0 / standard_gravity_m_per_s2, 0, "numbers in g taken for m/s^2"},
                                             {1e3, 0, "numbers in mm taken for m"},
                                             {1e-3, 0, "numbers in m taken for mm"},
                                             {1e3 * standard_gravity_m_per_s2, 0, "numbers in mm/s^2 taken for g"},
                                             {1e-3 / standard_gravity_m_per_s2, 0, "numbers in g taken for mm/s^2"}}};

constexpr std::array<Candidate, 9> quantities = {{{1.0, -1, "its integral in time, in the same unit of length"},
                                                  {1e3, -1, "its integral in time, in mm taken for m"},
                                                  {1e-3, -1, "its integral in time, in m taken for mm"},
                                                  {1.0, -2, "its second integral in time, in the same unit of length"},
                                                  {1e3, -2, "its second integral in time, in mm taken for m"},
                                                  {1e6, -2, "its second integral in time, in um taken for m"},
                                                  {1.0, 1, "its derivative in time, in the same unit of length"},
                                                  {1e3, 1, "its derivative in time, in mm taken for m"},
                                                  {1.0, 2, "its second derivative in time"}}};

double expected_db(const Candidate& candidate, double frequency_hz) {
    return 20.0 * std::log10(candidate.factor) +
           20.0 * candidate.derivatives * std::log10(2.0 * std::numbers::pi * frequency_hz);
}

/// Median distance of the strong bands from what a candidate makes of them, dB.
double distance_of(const LevelDifferences& differences, const Candidate& candidate) {
    std::vector<double> distances;
    for (std::size_t i = 0; i < differences.level_db.size(); ++i)
        if (differences.strong[i])
            distances.push_back(
                std::abs(differences.level_db[i] - expected_db(candidate, differences.frequency_hz[i])));
    return median(distances);
}

/// Bands that lie nearer to a candidate than to nothing wrong, less twice those that do not.
int votes(const LevelDifferences& differences, const Candidate& candidate) {
    int count = 0;
    for (std::size_t i = 0; i < differences.level_db.size(); ++i)
        count += std::abs(differences.level_db[i] - expected_db(candidate, differences.frequency_hz[i])) <
                         std::abs(differences.level_db[i])
                     ? 1
                     : -2;
    return count;
}

double likelihood(double distance_db) {
    return std::exp(-0.5 * std::pow(distance_db / level_scatter_db, 2));
}

}  // namespace

std::optional<LevelMistake> level_mistake(const LevelDifferences& differences) {
    const Candidate right{1.0, 0, ""};
    std::vector<double> strong;
    for (std::size_t i = 0; i < differences.level_db.size(); ++i)
        if (differences.strong[i]) strong.push_back(differences.level_db[i]);
    if (strong.size() < 3) return std::nullopt;  // a slope needs three
    const double right_db = distance_of(differences, right), none = prior_right * likelihood(right_db);
    double total = none, best = 0.0, least_db = farthest_db;
    const Candidate* explanation = nullptr;
    const auto consider = [&](const Candidate& candidate, double prior) {
        const double distance = distance_of(differences, candidate), share = prior * likelihood(distance);
        total += share;
        if (share <= best || distance > farthest_db) return;
        best = share;
        least_db = distance;
        explanation = &candidate;
    };
    for (const Candidate& candidate : units) consider(candidate, prior_unit / units.size());
    for (const Candidate& candidate : quantities) consider(candidate, prior_quantity / quantities.size());
    constexpr double kMost = 0.01;  // of false alarms
    // A slope crosses what was expected somewhere: there it is told by how much nearer the bands lie to it.
    constexpr double kTimesNearer = 3.0, kNearer_db = 3.0;
    const bool by_slope =
        explanation && explanation->derivatives != 0 && right_db > kTimesNearer * least_db + kNearer_db;
    if (!explanation || (none > kMost * total && !by_slope)) return std::nullopt;
    if (votes(differences, *explanation) <= 0) return std::nullopt;
    return LevelMistake{.factor = explanation->factor,
                        .derivatives = explanation->derivatives,
                        .says = explanation->says,
                        .level_db = median(strong),
                        .probability_none = none / total};
}

}  // namespace railpem::recordings::checks

#pragma once
// A level that is off, explained by a unit or a quantity that was taken for another.

#include <optional>
#include <string>
#include <vector>

namespace railpem::recordings::checks {

/// Levels of a channel over what is expected of it, dB, at band centres. `strong`: the bands that the expected power
/// lies in; the others decide only whether a mistake that moves all bands was made.
struct LevelDifferences {
    std::vector<double> frequency_hz, level_db;
    std::vector<bool> strong;
};

/// What was written = factor × the `derivatives`-th derivative in time of what was described (negative: integral).
struct LevelMistake {
    double factor = 1.0;
    int derivatives = 0;
    std::string says;               ///< "9.81 too low: numbers in g taken for m/s^2", "velocity in mm/s"
    double level_db = 0.0;          ///< median over the strong bands
    double probability_none = 1.0;  ///< that nothing is wrong
};

/// The mistake that explains the differences; nothing when none does, or when nothing need be wrong. A mistake moves
/// all bands alike, or by 6 dB per octave and derivative: half of the strong bands lie within 10 dB of it, and two
/// thirds of all bands nearer to it than to what was expected.
std::optional<LevelMistake> level_mistake(const LevelDifferences& differences);

}  // namespace railpem::recordings::checks

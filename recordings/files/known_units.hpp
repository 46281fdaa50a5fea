#pragma once
// Units as measuring systems write them into their files.

#include <optional>
#include <string>
#include <string_view>

namespace railpem::recordings {

/// Standard gravity, m/s² (CGPM 1901): what one g is.
inline constexpr double standard_gravity_m_per_s2 = 9.80665;

enum class Dimension { time, acceleration, velocity, length, frequency, other };

/// What a unit is of, and what one of it is in s, m/s², m/s, m or Hz. Of other dimensions (V, %, °C, N …) the factor
/// means nothing.
struct KnownUnit {
    Dimension dimension = Dimension::other;
    double factor = 1.0;
};

/// "m/s²", "m/s2", "m*s^-2", "mm/sec^2", "µm", "G", "msec" …; empty for a word that is not known as a unit. Brackets
/// around the unit are taken off.
std::optional<KnownUnit> known_unit(std::string_view unit);

/// The unit whose square per Hz a unit of a spectral density is: "g^2/Hz" → "g", "(m/s²)²/Hz" and "m^2/s^3" → "m/s^2".
/// Empty: it is no such unit.
std::string amplitude_unit(std::string_view density);

/// One spelling for the many: no blanks, no brackets, "µ" and "μ" are u, "²" and "**2" are ^2, "s2" is s^2.
std::string normalised_unit(std::string_view unit);

/// A name with its unit behind it, as a header has it: "a [g]", "Time (ms)", "acc, m/s^2", "v / km/h".
struct NameWithUnit {
    std::string name;
    std::string unit;  ///< as written, without the brackets; empty: there is none, or it is not known as a unit
};

/// Splits a column's name. What stands in the brackets is taken for a unit when it is known as one; otherwise the
/// whole is the name.
NameWithUnit name_with_unit(const std::string& header);

}  // namespace railpem::recordings

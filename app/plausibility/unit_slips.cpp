#include "app/plausibility/unit_slips.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace railpem::app {

namespace {

/// A unit that people write the number in, and what one of it is in SI.
struct OtherUnit {
    std::string name;
    double in_si;
};

const std::vector<OtherUnit>& other_units(const std::string& unit) {
    static const std::map<std::string, std::vector<OtherUnit>> all = {
        {"Pa", {{"GPa", 1e9}, {"MPa or N/mm^2", 1e6}, {"kPa", 1e3}}},
        {"m^4", {{"cm^4", 1e-8}, {"mm^4", 1e-12}}},
        {"m^2", {{"cm^2", 1e-4}, {"mm^2", 1e-6}}},
        {"m", {{"mm", 1e-3}, {"cm", 1e-2}, {"um", 1e-6}, {"km", 1e3}, {"a diameter", 0.5}}},
        {"kg", {{"t", 1e3}, {"g", 1e-3}, {"a weight in N", 1.0 / 9.81}, {"a weight in kN", 1e3 / 9.81}}},
        {"kg/m", {{"t/m", 1e3}, {"g/m", 1e-3}, {"a weight in N/m", 1.0 / 9.81}}},
        {"kg m^2", {{"t m^2", 1e3}, {"kg mm^2", 1e-6}}},
        {"N", {{"kN", 1e3}, {"MN", 1e6}, {"t", 9810.0}}},
        {"N/m", {{"kN/m or N/mm", 1e3}, {"MN/m or kN/mm", 1e6}, {"GN/m", 1e9}, {"mN/m", 1e-3}}},
        {"N s/m", {{"kN s/m", 1e3}, {"MN s/m", 1e6}}},
        {"m/s", {{"km/h", 1.0 / 3.6}, {"mm/s", 1e-3}}},
        {"m/s^2", {{"g", 9.81}, {"mm/s^2", 1e-3}}},
        {"Hz", {{"kHz", 1e3}, {"rad/s", 1.0 / (2.0 * 3.14159265358979)}}},
        {"1", {{"%", 0.01}}},
    };
    static const std::vector<OtherUnit> none;
    const auto found = all.find(unit);
    return found == all.end() ? none : found->second;
}

}  // namespace

std::string likely_unit(double value, const std::string& unit, double low, double high) {
    std::string best;
    double nearest = std::numeric_limits<double>::infinity(), place = 0.0;
    for (const OtherUnit& other : other_units(unit)) {
        const double meant = value * other.in_si;
        place += 1.0;
        if (!(meant >= low && meant <= high)) continue;
        // Units stand in the order in which they are mistaken: each place counts as much as a factor of e.
        const double distance = std::abs(std::log(meant / std::sqrt(low * high))) + place;
        if (distance < nearest) {
            nearest = distance;
            best = other.name + "?";
        }
    }
    return best;
}

}  // namespace railpem::app

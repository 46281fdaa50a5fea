#include "recordings/files/known_units.hpp"

#include <algorithm>
#include <map>

namespace railpem::recordings {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

constexpr double inch_m = 0.0254, foot_m = 0.3048;  // exact since 1959

const std::map<std::string, KnownUnit, std::less<>>& units() {
    using enum Dimension;
    static const std::map<std::string, KnownUnit, std::less<>> known = {
        {"s", {time, 1.0}},
        {"sec", {time, 1.0}},
        {"secs", {time, 1.0}},
        {"second", {time, 1.0}},
        {"seconds", {time, 1.0}},
        {"Sekunden", {time, 1.0}},
        {"ms", {time, 1e-3}},
        {"msec", {time, 1e-3}},
        {"msecs", {time, 1e-3}},
        {"millisecond", {time, 1e-3}},
        {"milliseconds", {time, 1e-3}},
        {"us", {time, 1e-6}},
        {"usec", {time, 1e-6}},
        {"microseconds", {time, 1e-6}},
        {"ns", {time, 1e-9}},
        {"nsec", {time, 1e-9}},
        {"nanoseconds", {time, 1e-9}},
        {"min", {time, 60.0}},
        {"minutes", {time, 60.0}},
        {"h", {time, 3600.0}},
        {"hours", {time, 3600.0}},
        {"days", {time, 86400.0}},
        {"m/s^2", {acceleration, 1.0}},
        {"m/s/s", {acceleration, 1.0}},
        {"mm/s^2", {acceleration, 1e-3}},
        {"cm/s^2", {acceleration, 1e-2}},
        {"um/s^2", {acceleration, 1e-6}},
        {"g", {acceleration, standard_gravity_m_per_s2}},
        {"G", {acceleration, standard_gravity_m_per_s2}},
        {"gn", {acceleration, standard_gravity_m_per_s2}},
        {"g0", {acceleration, standard_gravity_m_per_s2}},
        {"g_n", {acceleration, standard_gravity_m_per_s2}},
        {"g's", {acceleration, standard_gravity_m_per_s2}},
        {"gee", {acceleration, standard_gravity_m_per_s2}},
        {"mg", {acceleration, 1e-3 * standard_gravity_m_per_s2}},
        {"ug", {acceleration, 1e-6 * standard_gravity_m_per_s2}},
        {"Gal", {acceleration, 1e-2}},
        {"in/s^2", {acceleration, inch_m}},
        {"ft/s^2", {acceleration, foot_m}},
        {"m/s", {velocity, 1.0}},
        {"mm/s", {velocity, 1e-3}},
        {"cm/s", {velocity, 1e-2}},
        {"um/s", {velocity, 1e-6}},
        {"km/h", {velocity, 1.0 / 3.6}},
        {"kph", {velocity, 1.0 / 3.6}},
        {"mph", {velocity, 1609.344 / 3600.0}},
        {"in/s", {velocity, inch_m}},
        {"ips", {velocity, inch_m}},
        {"ft/s", {velocity, foot_m}},
        {"m", {length, 1.0}},
        {"mm", {length, 1e-3}},
        {"cm", {length, 1e-2}},
        {"um", {length, 1e-6}},
        {"nm", {length, 1e-9}},
        {"km", {length, 1e3}},
        {"in", {length, inch_m}},
        {"inch", {length, inch_m}},
        {"mil", {length, 1e-3 * inch_m}},
        {"mils", {length, 1e-3 * inch_m}},
        {"ft", {length, foot_m}},
        {"Hz", {frequency, 1.0}},
        {"kHz", {frequency, 1e3}},
        {"S/s", {frequency, 1.0}},
        {"kS/s", {frequency, 1e3}},
    };
    return known;
}

/// Words that loggers write for units of what is not a vibration.
bool is_other_unit(std::string_view unit) {
    static constexpr const char* known[] = {
        "V",    "mV",   "uV",    "A",    "mA",    "%",   "counts", "count",    "cts",         "LSB",  "bit",
        "bits", "EU",   "N",     "kN",   "Nm",    "Pa",  "kPa",    "hPa",      "MPa",         "bar",  "mbar",
        "K",    "degC", "C",     "degF", "deg",   "rad", "rad/s",  "deg/s",    "dps",         "um/m", "ustrn",
        "ppm",  "rpm",  "1/min", "Ohm",  "W",     "kW",  "dB",     "dB(A)",    "T",           "uT",   "kg",
        "lux",  "pC",   "mV/V",  "FS",   "m/s^3", "V/g", "mV/g",   "\xC2\xB0", "\xC2\xB0\x43"};
    return std::find(std::begin(known), std::end(known), unit) != std::end(known);
}

/// Behind a name, most single letters say where (transverse, north, horizontal), not in what.
bool stands_for_a_unit(std::string_view text, char opened_by) {
    if (!known_unit(text)) return false;
    return text.size() > 1 || opened_by == '[' || text == "g" || text == "s" || text == "m" || text == "V";
}

bool is_closed_by(char open, char close) {
    return (open == '[' && close == ']') || (open == '(' && close == ')') || (open == '{' && close == '}') ||
           (open == '<' && close == '>');
}

}  // namespace

std::string normalised_unit(std::string_view unit) {
    std::string text(unit);
    replace_all(text, "\xC2\xB5", "u");      // micro sign
    replace_all(text, "\xCE\xBC", "u");      // Greek mu
    replace_all(text, "\xC2\xB2", "^2");     // ²
    replace_all(text, "\xE2\x81\xBB", "-");  // superscript minus
    replace_all(text, "**", "^");
    replace_all(text, "\xC2\xB7", "*");  // middle dot
    replace_all(text, "^-^2", "^-2");
    replace_all(text, "-^2", "^-2");
    for (const char* per : {" s-2", " s^-2", "*s-2", "*s^-2", ".s-2", ".s^-2"}) replace_all(text, per, "/s^2");
    replace_all(text, "sec", "s");
    replace_all(text, "s2", "s^2");
    replace_all(text, "kmh", "km/h");
    replace_all(text, "km/hr", "km/h");
    replace_all(text, " ", "");
    if (text.size() >= 2 && is_closed_by(text.front(), text.back())) text = text.substr(1, text.size() - 2);
    return text;
}

std::string amplitude_unit(std::string_view density) {
    std::string text = normalised_unit(density);
    for (const char* same : {"m^2/s^3", "m^2/s^4/Hz", "m2/s^4/Hz", "m2/s3", "m^2*s^-3"})
        if (text == same) return "m/s^2";
    constexpr std::string_view per_hertz = "/Hz", square = "^2";
    if (!text.ends_with(per_hertz)) return "";
    text.resize(text.size() - per_hertz.size());
    if (text.ends_with(square)) {
        text.resize(text.size() - square.size());
    } else if (const std::size_t at = text.find("^2/"); at != std::string::npos && text.ends_with("^2")) {
        text.erase(at, square.size());
    }
    if (text.size() >= 2 && is_closed_by(text.front(), text.back())) text = text.substr(1, text.size() - 2);
    // "mm^2/s^2/Hz" is the square of mm/s.
    if (const std::size_t at = text.find("^2/"); at != std::string::npos) text.erase(at, square.size());
    return units().contains(text) ? text : "";
}

std::optional<KnownUnit> known_unit(std::string_view unit) {
    if (unit.size() > 2 && !amplitude_unit(unit).empty()) return KnownUnit{};
    std::string plain(unit);
    replace_all(plain, " ", "");
    for (const std::string& spelling : {normalised_unit(unit), plain}) {
        if (const auto found = units().find(spelling); found != units().end()) return found->second;
        if (is_other_unit(spelling)) return KnownUnit{};
    }
    return std::nullopt;
}

NameWithUnit name_with_unit(const std::string& header) {
    const auto split = [&](std::size_t name_end, std::size_t unit_begin, std::size_t unit_end,
                           char opened_by) -> NameWithUnit {
        std::string name = header.substr(0, name_end), unit = header.substr(unit_begin, unit_end - unit_begin);
        while (!name.empty() && name.back() == ' ') name.pop_back();
        while (!unit.empty() && unit.front() == ' ') unit.erase(0, 1);
        while (!unit.empty() && unit.back() == ' ') unit.pop_back();
        if (name.empty() || unit.empty() || !stands_for_a_unit(unit, opened_by)) return {header, ""};
        return {name, unit};
    };
    if (!header.empty() && (header.back() == ']' || header.back() == ')' || header.back() == '}')) {
        const char open = header.back() == ']' ? '[' : header.back() == ')' ? '(' : '{';
        // The unit itself may hold brackets of the same kind: "a ((m/s^2)^2/Hz)".
        int depth = 0;
        for (std::size_t at = header.size(); at-- > 0;) {
            if (header[at] == header.back()) ++depth;
            if (header[at] == open && --depth == 0) return split(at, at + 1, header.size() - 1, open);
        }
    }
    for (const char* separator : {" / ", ", ", " in "})
        if (const std::size_t at = header.rfind(separator); at != std::string::npos)
            if (NameWithUnit found = split(at, at + std::string_view(separator).size(), header.size(), ' ');
                !found.unit.empty())
                return found;
    return {header, ""};
}

}  // namespace railpem::recordings

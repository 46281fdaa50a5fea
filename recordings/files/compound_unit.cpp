#include "recordings/files/compound_unit.hpp"

#include <array>
#include <map>

#include "recordings/files/known_units.hpp"

namespace railpem::recordings {
namespace {

bool take_end(std::string& text, std::string_view end) {
    if (!text.ends_with(end)) return false;
    text.resize(text.size() - end.size());
    return true;
}

/// Takes off one pair of brackets that spans the whole.
std::string without_brackets(const std::string& text) {
    if (text.size() < 2 || text.front() != '(' || text.back() != ')') return text;
    int depth = 0;
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (depth == 0) return text;
    }
    return text.substr(1, text.size() - 2);
}

bool is_vibration_unit(const std::string& text) {
    const std::optional<KnownUnit> unit = known_unit(text);
    return unit && (unit->dimension == Dimension::acceleration || unit->dimension == Dimension::velocity ||
                    unit->dimension == Dimension::length);
}

}  // namespace

std::optional<std::string> unit_of_density(std::string_view unit) {
    std::string text = normalised_unit(unit);
    static const std::map<std::string, std::string, std::less<>> written_out = {
        {"m^2/s^3", "m/s^2"}, {"m2/s3", "m/s^2"}, {"m2/s^3", "m/s^2"}, {"m^2/s3", "m/s^2"}};
    if (const auto found = written_out.find(text); found != written_out.end()) return found->second;
    if (!take_end(text, "/Hz") && !take_end(text, "*s")) return std::nullopt;
    text = without_brackets(text);
    // Length squared over a power of time: "m^2/s^4".
    static constexpr std::array<std::pair<const char*, const char*>, 4> powers = {
        {{"/s^4", "/s^2"}, {"/s4", "/s^2"}, {"/s^2", "/s"}, {"", ""}}};
    for (const auto& [squared, plain] : powers) {
        std::string base = text;
        if (!take_end(base, squared)) continue;
        if (!take_end(base, "^2") && !take_end(base, "2")) continue;
        base = without_brackets(base) + plain;
        if (is_vibration_unit(base)) return base;
    }
    return std::nullopt;
}

std::optional<double> newtons_of(std::string_view unit) {
    static const std::map<std::string, double, std::less<>> forces = {
        {"N", 1.0}, {"kN", 1e3}, {"MN", 1e6}, {"mN", 1e-3}, {"lbf", 4.4482216152605}, {"lbs", 4.4482216152605}};
    const auto found = forces.find(normalised_unit(unit));
    return found == forces.end() ? std::nullopt : std::optional(found->second);
}

PerForce unit_per_force(std::string_view unit) {
    const std::string text = normalised_unit(unit);
    for (const char* force : {"lbf", "lbs", "kN", "MN", "mN", "N"}) {
        const std::string name(force);
        std::string vibration = text;
        if (take_end(vibration, "/" + name)) return {without_brackets(vibration), *newtons_of(name), true};
        // The force in the middle: "m/N/s^2", "m/(N*s^2)".
        for (const auto& [before, after] : {std::pair<std::string, std::string>{"/" + name + "/", ""},
                                            {"/(" + name + "*", ")"},
                                            {"/(s^2*" + name, ")"}})
            if (const std::size_t at = text.find(before); at != std::string::npos && text.ends_with(after)) {
                std::string rest = text.substr(at + before.size());
                rest.resize(rest.size() - after.size());
                return {text.substr(0, at) + "/" + (rest.empty() ? "s^2" : rest), *newtons_of(name), true};
            }
    }
    return {text, 1.0, false};
}

}  // namespace railpem::recordings

#include "recordings/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cassert>

#include "parameters/parameter_error.hpp"

namespace railpem::recordings {
namespace {

struct Unit {
    const char* name;
    double factor;
};

const std::vector<Unit>& units_of(ChannelQuantity quantity) {
    static const std::vector<Unit> acceleration = {{"m/s^2", 1.0},
                                                   {"g", standard_gravity_m_per_s2},
                                                   {"mg", 1e-3 * standard_gravity_m_per_s2},
                                                   {"mm/s^2", 1e-3},
                                                   {"cm/s^2", 1e-2},
                                                   {"um/s^2", 1e-6}};
    static const std::vector<Unit> velocity = {
        {"m/s", 1.0}, {"mm/s", 1e-3}, {"cm/s", 1e-2}, {"um/s", 1e-6}, {"km/h", 1.0 / 3.6}};
    static const std::vector<Unit> displacement = {{"m", 1.0}, {"mm", 1e-3}, {"um", 1e-6}, {"cm", 1e-2}};
    static const std::vector<Unit> speed = {{"m/s", 1.0}, {"km/h", 1.0 / 3.6}};
    static const std::vector<Unit> mileage = {{"m", 1.0}, {"km", 1e3}};
    switch (quantity) {
        case ChannelQuantity::acceleration:
            return acceleration;
        case ChannelQuantity::velocity:
            return velocity;
        case ChannelQuantity::displacement:
            return displacement;
        case ChannelQuantity::speed:
            return speed;
        case ChannelQuantity::mileage:
            return mileage;
    }
    assert(false);
    return acceleration;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// One spelling for the many: "µm", "μm" → "um"; "m/s²", "m/s2", "m/s**2", "m s-2" → "m/s^2".
std::string normalised(std::string_view unit) {
    std::string text(unit);
    replace_all(text, "\xC2\xB5", "u");  // micro sign
    replace_all(text, "\xCE\xBC", "u");  // Greek mu
    replace_all(text, "\xC2\xB2", "^2");
    replace_all(text, "**2", "^2");
    replace_all(text, "s2", "s^2");
    replace_all(text, " s-2", "/s^2");
    replace_all(text, " s^-2", "/s^2");
    replace_all(text, "kmh", "km/h");
    replace_all(text, " ", "");
    return text;
}

}  // namespace

std::vector<std::string> allowed_units(ChannelQuantity quantity) {
    std::vector<std::string> names;
    for (const Unit& unit : units_of(quantity)) names.emplace_back(unit.name);
    return names;
}

double to_si_factor(std::string_view unit, ChannelQuantity quantity, const std::string& key) {
    if (unit.empty()) return 1.0;
    const std::string name = normalised(unit);
    for (const Unit& candidate : units_of(quantity))
        if (name == candidate.name) return candidate.factor;
    throw parameters::ParameterError(key, fmt::format("'{}' is not a unit of {}", unit, quantity_name(quantity)),
                                     fmt::format("{}", fmt::join(allowed_units(quantity), ", ")));
}

std::string si_unit(ChannelQuantity quantity) {
    return units_of(quantity).front().name;
}

std::string value_unit(const ChannelDescription& channel) {
    return channel.scale == Scale::unknown ? "(unknown scale)" : si_unit(channel.quantity);
}

std::string quantity_name(ChannelQuantity quantity) {
    static const char* const names[] = {"acceleration", "velocity", "displacement", "speed", "mileage"};
    return names[static_cast<int>(quantity)];
}

bool is_vibration(ChannelQuantity quantity) {
    return quantity != ChannelQuantity::speed && quantity != ChannelQuantity::mileage;
}

int derivatives_to_acceleration(ChannelQuantity quantity) {
    assert(is_vibration(quantity));
    return quantity == ChannelQuantity::acceleration ? 0 : quantity == ChannelQuantity::velocity ? 1 : 2;
}

}  // namespace railpem::recordings

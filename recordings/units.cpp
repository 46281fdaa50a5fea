#include "recordings/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cassert>

#include "parameters/parameter_error.hpp"

namespace railpem::recordings {
namespace {

const std::vector<const char*>& units_of(ChannelQuantity quantity) {
    static const std::vector<const char*> acceleration = {"m/s^2", "g", "mg", "mm/s^2", "cm/s^2", "um/s^2"};
    static const std::vector<const char*> velocity = {"m/s", "mm/s", "cm/s", "um/s", "km/h"};
    static const std::vector<const char*> displacement = {"m", "mm", "um", "cm"};
    static const std::vector<const char*> speed = {"m/s", "km/h"};
    static const std::vector<const char*> mileage = {"m", "km"};
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

Dimension dimension_of(ChannelQuantity quantity) {
    switch (quantity) {
        case ChannelQuantity::acceleration:
            return Dimension::acceleration;
        case ChannelQuantity::velocity:
        case ChannelQuantity::speed:
            return Dimension::velocity;
        case ChannelQuantity::displacement:
        case ChannelQuantity::mileage:
            return Dimension::length;
    }
    assert(false);
    return Dimension::other;
}

}  // namespace

std::vector<std::string> allowed_units(ChannelQuantity quantity) {
    std::vector<std::string> names;
    for (const char* unit : units_of(quantity)) names.emplace_back(unit);
    return names;
}

std::optional<double> factor_of_unit(std::string_view unit, ChannelQuantity quantity) {
    const std::optional<KnownUnit> known = known_unit(unit);
    if (!known || known->dimension != dimension_of(quantity)) return std::nullopt;
    return known->factor;
}

double to_si_factor(std::string_view unit, ChannelQuantity quantity, const std::string& key) {
    if (unit.empty()) return 1.0;
    if (const std::optional<double> factor = factor_of_unit(unit, quantity)) return *factor;
    throw parameters::ParameterError(key, fmt::format("'{}' is not a unit of {}", unit, quantity_name(quantity)),
                                     fmt::format("{}", fmt::join(allowed_units(quantity), ", ")));
}

std::string si_unit(ChannelQuantity quantity) {
    return units_of(quantity).front();
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

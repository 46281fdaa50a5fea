#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/files/known_units.hpp"
#include "recordings/recording_description.hpp"

namespace railpem::recordings {

/// Factor from `unit` to the SI unit of the quantity (m/s², m/s, m). Empty unit: 1. Accepts ^2, ² and 2, and both signs
/// for micro. Throws parameters::ParameterError with `key`, listing what is allowed, for a unit that is not one of the
/// quantity.
double to_si_factor(std::string_view unit, ChannelQuantity quantity, const std::string& key);

/// The same without a refusal: empty when `unit` is not one of the quantity.
std::optional<double> factor_of_unit(std::string_view unit, ChannelQuantity quantity);

/// Units that to_si_factor accepts for the quantity.
std::vector<std::string> allowed_units(ChannelQuantity quantity);

/// SI unit of the quantity: m/s^2, m/s or m.
std::string si_unit(ChannelQuantity quantity);

/// What stands behind a value of the channel: its SI unit, or "(unknown scale)" when its unit cannot be trusted.
std::string value_unit(const ChannelDescription& channel);

/// Name as in the description: "acceleration", …
std::string quantity_name(ChannelQuantity quantity);

/// How often the quantity must be differentiated in time to be an acceleration: 0, 1 or 2. Asserts a vibration
/// quantity.
int derivatives_to_acceleration(ChannelQuantity quantity);

/// True for acceleration, velocity and displacement: a vibration, not a state of the train.
bool is_vibration(ChannelQuantity quantity);

}  // namespace railpem::recordings

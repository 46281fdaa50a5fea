#pragma once
// What the sensors of an imperfect world add: calibration, drift, coloured noise, a tone.

#include <cstdint>
#include <vector>

#include "simulate/recording.hpp"
#include "simulate/world_draws.hpp"
#include "simulate/world_parameters.hpp"

namespace railpem::simulate {

/// Calibration of every channel, drawn by seed and channel; empty where the world leaves them as they are.
std::vector<ChannelDraw> draw_calibration(const WorldParameters& world, std::size_t channels, std::uint64_t seed);

/// Multiplies the samples by what `draw_calibration` gave, then adds noise and tone. The channel of the tone is written
/// into the recording's draws.
void spoil_channels(Recording& recording, const WorldParameters& world, std::uint64_t seed);

}  // namespace railpem::simulate

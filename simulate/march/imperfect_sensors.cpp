#include "simulate/march/imperfect_sensors.hpp"

#include <cmath>
#include <numbers>

#include "simulate/march/sensor_chain.hpp"
#include "simulate/numerics/random_numbers.hpp"

namespace railpem::simulate {

namespace {

// Purposes of derived seeds; noise: one per channel.
constexpr std::uint64_t for_calibration = 341;
constexpr std::uint64_t for_tone = 342;
constexpr std::uint64_t for_coloured_noise = 400;

void calibrate(std::vector<double>& samples, const ChannelDraw& draw) {
    const double last = static_cast<double>(samples.size()) - 1.0;
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] *= draw.gain * (1.0 + draw.drift * (static_cast<double>(i) / last - 0.5));
}

void add_tone(Recording& recording, const WorldParameters& world, std::uint64_t seed) {
    const std::uint64_t own = derived_seed(seed, for_tone);
    const auto count = static_cast<double>(recording.channels.size());
    Channel& channel = recording.channels[static_cast<std::size_t>(count * uniform_at(own, 0))];
    const double phase = 2.0 * std::numbers::pi * uniform_at(own, 1);
    const double step = 2.0 * std::numbers::pi * world.tone_hz / recording.sampling_rate_hz;
    std::vector<double>& samples = channel.acceleration_m_per_s2;
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] += std::numbers::sqrt2 * world.tone_rms_m_per_s2 * std::cos(step * static_cast<double>(i) + phase);
    recording.making.draws.tone_channel = channel.name;
}

}  // namespace

std::vector<ChannelDraw> draw_calibration(const WorldParameters& world, std::size_t channels, std::uint64_t seed) {
    std::vector<ChannelDraw> draws;
    if (world.gain_scatter <= 0.0 && world.gain_drift <= 0.0) return draws;
    const std::uint64_t own = derived_seed(seed, for_calibration);
    for (std::size_t c = 0; c < channels; ++c) {
        const auto [gain, drift] = normal_pair_at(own, c);
        draws.push_back({.gain = 1.0 + world.gain_scatter * gain, .drift = world.gain_drift * drift});
    }
    return draws;
}

void spoil_channels(Recording& recording, const WorldParameters& world, std::uint64_t seed) {
    WorldDraws& draws = recording.making.draws;
    draws.channels = draw_calibration(world, recording.channels.size(), seed);
    for (std::size_t c = 0; c < draws.channels.size(); ++c)
        calibrate(recording.channels[c].acceleration_m_per_s2, draws.channels[c]);
    if (world.noise_rms_m_per_s2 > 0.0)
        for (std::size_t c = 0; c < recording.channels.size(); ++c) {
            std::vector<double>& samples = recording.channels[c].acceleration_m_per_s2;
            const std::vector<double> noise =
                draw_pink_noise(world.noise_rms_m_per_s2, world.noise_corner_hz, samples.size(),
                                recording.sampling_rate_hz, derived_seed(seed, for_coloured_noise + c));
            for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += noise[i];
        }
    if (world.tone_rms_m_per_s2 > 0.0) add_tone(recording, world, seed);
}

}  // namespace railpem::simulate

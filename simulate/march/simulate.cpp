#include "simulate/march/simulate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <numbers>

#include "parameters/parameter_error.hpp"
#include "simulate/march/imperfect_sensors.hpp"
#include "simulate/march/sensor_chain.hpp"
#include "simulate/march/world.hpp"
#include "simulate/numerics/random_numbers.hpp"
#include "simulate/numerics/relaxation_chain.hpp"

namespace railpem::simulate {

using parameters::ParameterError;

namespace {

constexpr std::uint64_t for_noise = 100;        // purpose of derived seeds, one per channel
constexpr std::uint64_t for_noise_floor = 200;  // the same for the floor that all channels have

void refuse(const pem::CaseParameters& parameters, const Options& options) {
    // A Hann window resolves what lies two lines above zero: the record must hold two periods of the lowest frequency.
    const double shortest = 2.0 / parameters.frequency.from_hz;
    if (!(options.seconds >= shortest))
        throw ParameterError(
            "--seconds",
            fmt::format("{:g} s is too short for a single average at {:g} Hz, the case's lowest frequency",
                        options.seconds, parameters.frequency.from_hz),
            fmt::format("at least {:g} s", shortest));
    const double lowest_rate = 2.0 * parameters.frequency.to_hz;
    if (!(options.sampling_rate_hz >= lowest_rate))
        throw ParameterError("--rate",
                             fmt::format("{:g} Hz cannot show the case's highest frequency, {:g} Hz",
                                         options.sampling_rate_hz, parameters.frequency.to_hz),
                             fmt::format("at least {:g} Hz", lowest_rate));
    const std::vector<std::string>& names = channel_names();
    for (const pem::SensorParameters& sensor : parameters.sensors)
        if (std::find(names.begin(), names.end(), sensor.channel) == names.end())
            throw ParameterError("sensor.channel", fmt::format("no channel \"{}\"", sensor.channel),
                                 fmt::format("{}", fmt::join(names, ", ")));
}

/// One sensor per channel: those of the case chained where several speak of the same channel.
std::vector<pem::SensorParameters> sensors_by_channel(const pem::CaseParameters& parameters) {
    std::vector<pem::SensorParameters> sensors;
    for (const std::string& name : channel_names()) {
        pem::SensorParameters sensor{.channel = name};
        for (const pem::SensorParameters& given : parameters.sensors) {
            if (given.channel != name) continue;
            sensor.gain *= given.gain;
            sensor.delay_s += given.delay_s;
            if (given.resonance_frequency_hz > 0.0) {
                sensor.resonance_frequency_hz = given.resonance_frequency_hz;
                sensor.resonance_damping_ratio = given.resonance_damping_ratio;
            }
            if (given.noise_rms_m_per_s2 > 0.0) {
                sensor.noise_rms_m_per_s2 = given.noise_rms_m_per_s2;
                sensor.noise_slope_db_per_octave = given.noise_slope_db_per_octave;
            }
        }
        sensors.push_back(sensor);
    }
    return sensors;
}

std::vector<Channel> empty_channels(const pem::CaseParameters& parameters, std::size_t samples) {
    const double pivot = 0.5 * parameters.vehicle.bogie_distance_m;
    std::vector<Channel> channels;
    for (std::size_t i = 0; i < channel_names().size(); ++i) {
        Channel channel{.name = channel_names()[i],
                        .location = i < 4 ? "wheel" : (i < 6 ? "bogie" : "body"),
                        .acceleration_m_per_s2 = {}};
        if (i < 6) channel.index = static_cast<int>(i < 4 ? i + 1 : i - 3);
        if (i == 6 || i == 7) channel.position_m = i == 6 ? pivot : -pivot;
        channel.acceleration_m_per_s2.reserve(samples);
        channels.push_back(channel);
    }
    return channels;
}

/// The marching step. The method damps by itself, 1.6e-4 of critical at 180 Hz with 0.2 ms and with the third power of
/// the step: where the rail resonates on pads that hardly damp this is to be 1/2000 of the pads' own damping. With 0.2
/// ms and a loss factor of 0.08 the response next to the resonance was 0.6 % off (Modulation.PadsThatHardlyDamp).
double largest_step_s(const pem::CaseParameters& parameters, const Options& options) {
    constexpr double kOmega = 2.0 * std::numbers::pi * 180.0, kOwnLoss = 3.2e-4, kAtStep_s = 0.2e-3,
                     kShare = 1.0 / 2000.0;
    const track::PadParameters& pads = parameters.track.pads;
    const std::complex<double> pad =
        pad_modulus(pads)(kOmega / (2.0 * std::numbers::pi)) +
        std::complex<double>(
            0.0, kOmega * pad_dashpot_n_s_per_m(pads) / (pads.dynamic_to_static_ratio * pads.static_stiffness_n_per_m));
    const double loss = std::max(0.0, pad.imag() / pad.real());
    constexpr double kLeast = 0.25;  // of the step: pads without any damping
    return std::min(options.largest_step_s, kAtStep_s * std::max(kLeast, std::cbrt(kShare * loss / kOwnLoss)));
}

/// When the march begins and ends so that settling, filters and delays have all they need, in steps from the first
/// sample.
struct Schedule {
    int ratio = 1;  ///< steps per sample
    double step_s = 0.0;
    std::int64_t first = 0, last = 0;
    std::size_t samples = 0;
};

Schedule make_schedule(const Options& options, const std::vector<FilteredChannel>& filters, int ratio) {
    Schedule schedule{.ratio = ratio, .step_s = 1.0 / (options.sampling_rate_hz * ratio)};
    schedule.samples = static_cast<std::size_t>(std::llround(options.seconds * options.sampling_rate_hz));
    int back = 0;
    int ahead = 0;
    for (const FilteredChannel& channel : filters) {
        back = std::max(back, channel.filter().reach_back());
        ahead = std::max(ahead, channel.filter().before);
    }
    schedule.first = -back - static_cast<std::int64_t>(std::ceil(options.settling_s / schedule.step_s));
    schedule.last = static_cast<std::int64_t>(schedule.samples - 1) * ratio + ahead;
    return schedule;
}

/// The noise of the sensors that the case names, and the white floor of every channel; independent of one another.
void add_noise(Recording& recording, const std::vector<pem::SensorParameters>& sensors, const Options& options) {
    const auto add = [&](std::size_t c, const pem::SensorParameters& sensor, std::uint64_t purpose) {
        if (sensor.noise_rms_m_per_s2 <= 0.0) return;
        std::vector<double>& samples = recording.channels[c].acceleration_m_per_s2;
        const std::vector<double> noise =
            draw_noise(sensor, samples.size(), recording.sampling_rate_hz, derived_seed(options.seed, purpose + c));
        for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += noise[i];
    };
    for (std::size_t c = 0; c < sensors.size(); ++c) {
        add(c, sensors[c], for_noise);
        add(c, {.channel = sensors[c].channel, .noise_rms_m_per_s2 = options.noise_rms_m_per_s2}, for_noise_floor);
    }
}

/// An excess of sleeper passing over what the moving wheels meet by themselves; all of it where they stand.
void add_passing(Excitation& excitation, const World& world, const pem::CaseParameters& parameters, Mode mode) {
    const double factor = parameters.sleeper_passing.amplitude_factor;
    const double excess = mode == Mode::moving ? (factor > 0.0 ? factor - 1.0 : 0.0) : factor;
    if (excess == 0.0) return;
    constexpr int places = 96;  // linear interpolation between them misses 0.05 % of the line
    std::array<std::vector<double>, 4> deflection = quasi_static_deflection(world, places);
    const double phase = parameters.track.wheel_offset_m / parameters.track.spacing_m;
    for (std::size_t j = 0; j < 4; ++j) {
        double mean = 0.0;
        for (const double value : deflection[j]) mean += value / places;
        for (double& value : deflection[j]) value = -excess * (value - mean);
        // Tables begin with wheel 1 over a seat; the distance 0 finds it wheel_offset ahead of one.
        std::rotate(deflection[j].begin(),
                    deflection[j].begin() + static_cast<std::ptrdiff_t>(std::floor(phase * places)) % places,
                    deflection[j].end());
        excitation.passing_m[j] = deflection[j];
    }
}

/// The march itself: step by step, every channel filtered and sampled on the way.
void march(World& world, const Excitation& excitation, const Travel& travel, const Schedule& schedule,
           const Options& options, std::vector<FilteredChannel>& filters, Recording& recording) {
    const std::int64_t steps = schedule.last - schedule.first;
    const double record_end = static_cast<double>(schedule.samples) / options.sampling_rate_hz;
    std::int64_t lost = 0;
    for (std::int64_t n = schedule.first; n < schedule.last; ++n) {
        advance(world, excitation, travel, static_cast<double>(n) * schedule.step_s);
        const std::int64_t now = n + 1;
        for (std::size_t c = 0; c < filters.size(); ++c) {
            filters[c].push(world.vehicle.channels[c].dot(world.vehicle_state.acceleration));
            const std::int64_t at = now - filters[c].filter().before;  // the step this output belongs to
            std::vector<double>& samples = recording.channels[c].acceleration_m_per_s2;
            if (at >= 0 && at % schedule.ratio == 0 && samples.size() < schedule.samples)
                samples.push_back(filters[c].output());
        }
        for (std::size_t j = 0; j < 4; ++j)
            lost += world.junction.contact.nonlinearity > 0.0 &&
                            world.junction.force[2 * static_cast<Eigen::Index>(j) + 1] <= 0.0
                        ? 1
                        : 0;
        if (options.observer && now >= 0 && static_cast<double>(now) * schedule.step_s <= record_end)
            options.observer(look(world, static_cast<double>(now) * schedule.step_s));
        if (options.progress && (now - schedule.first) % std::max<std::int64_t>(1, steps / 100) == 0)
            options.progress(static_cast<double>(now - schedule.first) * schedule.step_s,
                             static_cast<double>(steps) * schedule.step_s);
    }
    recording.making.contact_lost_share = static_cast<double>(lost) / (4.0 * static_cast<double>(steps));
    recording.making.solves_per_step = static_cast<double>(world.solves) / static_cast<double>(steps);
}

/// The record before the first step: its channels, and the speed that it states.
Recording empty_recording(const pem::CaseParameters& parameters, const Options& options, const Travel& travel,
                          std::size_t samples) {
    Recording recording{.sampling_rate_hz = options.sampling_rate_hz,
                        .speed_m_per_s = travel.speed_m_per_s,
                        .speed_standard_error_m_per_s = options.speed_fluctuation * travel.speed_m_per_s,
                        .payload_kg = parameters.vehicle.payload_kg,
                        .channels = empty_channels(parameters, samples),
                        .speed_channel_m_per_s = {},
                        .making = {}};
    WorldDraws& draws = recording.making.draws;
    describe_travel(travel, options.seconds, draws);
    if (!travel.curve.speed_m_per_s.empty()) {
        recording.speed_m_per_s = draws.mean_speed_m_per_s;
        recording.speed_standard_error_m_per_s = draws.speed_rms_m_per_s;
    }
    if (options.speed_channel)
        for (std::size_t i = 0; i < samples; ++i)
            recording.speed_channel_m_per_s.push_back(travel.speed(static_cast<double>(i) / options.sampling_rate_hz));
    return recording;
}

/// The factors of the seats that the wheels pass, from that behind the last wheel to that before the first.
void describe_seats(const World& world, double way_m, WorldDraws& draws) {
    const SeatScatter& scatter = world.track.variation.scatter;
    if (!scatter.any()) return;
    const double spacing = world.track.spacing_m;
    const double way = world.mode == Mode::moving ? way_m : 0.0;
    draws.first_seat = static_cast<std::int64_t>(std::floor((world.wheel_offset_m - world.behind_m[3]) / spacing));
    const auto last = static_cast<std::int64_t>(std::ceil((world.wheel_offset_m + way) / spacing));
    for (std::int64_t seat = draws.first_seat; seat <= last; ++seat) {
        draws.pad_stiffness.push_back(scatter.pad_factor(seat));
        draws.support_stiffness.push_back(scatter.support_factor(seat));
    }
}

}  // namespace

Recording simulate(const pem::CaseParameters& parameters, const Options& options) {
    refuse(parameters, options);
    const auto began = std::chrono::steady_clock::now();
    const double speed =
        options.speed_m_per_s > 0.0 ? options.speed_m_per_s : parameters.running.speeds_m_per_s.front();
    const int ratio =
        static_cast<int>(std::ceil(1.0 / (options.sampling_rate_hz * largest_step_s(parameters, options)) - 1e-9));
    const std::vector<pem::SensorParameters> sensors = sensors_by_channel(parameters);
    std::vector<FilteredChannel> filters;
    for (const pem::SensorParameters& sensor : sensors)
        filters.emplace_back(make_filter(sensor, options.sampling_rate_hz, ratio));
    const Schedule schedule = make_schedule(options, filters, ratio);
    const double start_s = static_cast<double>(schedule.first) * schedule.step_s;
    const double end_s = static_cast<double>(schedule.last) * schedule.step_s;

    const Travel travel = make_travel(speed, options, start_s, end_s);
    World world = make_world(parameters, options, speed, schedule.step_s, travel.distance(start_s));
    Recording recording = empty_recording(parameters, options, travel, schedule.samples);
    Making& making = recording.making;
    Excitation excitation =
        make_excitation(parameters, options, travel, start_s, end_s, schedule.step_s, &making.draws);
    add_passing(excitation, world, parameters, options.mode);
    describe_seats(world, travel.distance(options.seconds), making.draws);

    march(world, excitation, travel, schedule, options, filters, recording);
    spoil_channels(recording, options.world, options.seed);
    add_noise(recording, sensors, options);

    making.step_s = schedule.step_s;
    making.profile_rms_m = profile_rms(excitation.profile, travel.distance(0.0), travel.distance(options.seconds));
    making.profile_length_m = excitation.profile.step_m * static_cast<double>(excitation.profile.height_m.size());
    making.shortest_wavelength_m =
        shortest_wavelength_m(parameters.irregularity, highest_speed_m_per_s(travel), schedule.step_s);
    making.chain_error = world.track.law.chain.largest_error;
    making.seconds_per_second =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() / options.seconds;
    return recording;
}

}  // namespace railpem::simulate

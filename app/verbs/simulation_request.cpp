#include "app/verbs/simulation_request.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/input_error.hpp"
#include "app/run_inputs.hpp"
#include "app/schema/hide_option.hpp"
#include "app/schema/read_table.hpp"
#include "app/schema/recording_schema.hpp"
#include "app/schema/world_option.hpp"
#include "recordings/text/read_csv.hpp"
#include "simulate/march/simulate.hpp"

namespace railpem::app {

namespace {

constexpr double kMostSeconds = 36000.0;   ///< ten hours: 2.6 GB of samples at 1 kHz
constexpr double kMostSamples = 5e7;       ///< per channel: 3.6 GB in nine
constexpr double kMostRate_hz = 100000.0;  ///< far beyond what a model of vehicle and track can say
constexpr double kHighestSpeed_m_per_s = 200.0;

simulate::MeasuredProfile read_profile(const std::string& path) {
    note_input(path);
    try {
        const recordings::DataTable table = recordings::read_csv(path, {"position_m", "height_m"});
        for (const std::vector<double>& column : table.columns)
            for (std::size_t i = 0; i < column.size(); ++i)
                if (!std::isfinite(column[i]) || (&column == &table.columns[0] && i > 0 && column[i] <= column[i - 1]))
                    refuse_option("--profile " + path,
                                  fmt::format("value {} of {} is missing or out of order", i + 1,
                                              table.names[&column == &table.columns[0] ? 0 : 1]),
                                  "increasing positions, every height known");
        return {table.columns[0], table.columns[1]};
    } catch (const recordings::ReadError& error) {
        throw refused(error);
    }
}

/// Speeds against time, m/s; a train may stop, but it has to have moved.
simulate::SpeedTable read_speed_profile(const std::string& path) {
    const std::string option = "--speed-profile " + path;
    note_input(path);
    try {
        recordings::DataTable table = recordings::read_csv(path, {"time_s", "speed_m_per_s"});
        const std::vector<double>&time = table.columns[0], &speed = table.columns[1];
        bool moves = false;
        for (std::size_t i = 0; i < time.size(); ++i) {
            if (!std::isfinite(time[i]) || (i > 0 && time[i] <= time[i - 1]))
                refuse_option(option, fmt::format("time {} is missing or out of order", i + 1), "increasing times");
            if (!(speed[i] >= 0.0 && speed[i] <= kHighestSpeed_m_per_s))
                refuse_option(option, fmt::format("speed {} cannot be {:g} m/s", i + 1, speed[i]),
                              fmt::format("between 0 and {:g} m/s", kHighestSpeed_m_per_s));
            moves = moves || speed[i] > 0.0;
        }
        if (time.size() < 2 || !moves)
            refuse_option(option, time.size() < 2 ? "holds less than two rows" : "the train never moves",
                          "two rows or more, one speed of which is greater than 0");
        return {std::move(table.columns[0]), std::move(table.columns[1])};
    } catch (const recordings::ReadError& error) {
        throw refused(error);
    }
}

simulate::Options simulation_options(const SimulationRequest& request, const World& world, const CaseWithHidden& with) {
    simulate::Options options;
    options.mode = request.standing ? simulate::Mode::standing : simulate::Mode::moving;
    options.seconds = request.seconds;
    options.sampling_rate_hz = request.rate_hz;
    options.speed_m_per_s = request.speed.value_or(0.0);
    options.seed = static_cast<std::uint64_t>(request.seed);
    if (request.profile_seed) options.profile_seed = static_cast<std::uint64_t>(*request.profile_seed);
    options.profile_length_m = request.profile_length_m;
    if (!request.profile.empty()) options.measured_profile = read_profile(request.profile);
    options.speed_fluctuation = request.speed_fluctuation;
    if (!request.speed_profile.empty()) options.speed_table = read_speed_profile(request.speed_profile);
    options.speed_channel = request.speed_channel;
    options.world = world.parameters;
    options.noise_rms_m_per_s2 = request.noise;
    options.only_here = with.only_here;
    return options;
}

}  // namespace

[[noreturn]] void refuse_option(const std::string& option, const std::string& what, const std::string& allowed) {
    throw input_error("", "", {.option = option}, {.what = what, .allowed = allowed, .hint = ""});
}

void check_simulation(const SimulationRequest& request) {
    const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
    if (!within(request.seconds, 0.0, kMostSeconds))
        refuse_option("--seconds", fmt::format("a record of {:g} s cannot be made", request.seconds),
                      fmt::format("greater than 0, at most {:g} s", kMostSeconds));
    for (const auto& [option, seed] :
         {std::pair("--seed", std::optional(request.seed)), std::pair("--profile-seed", request.profile_seed)})
        if (seed && *seed < 0)
            refuse_option(option, fmt::format("cannot be {}", *seed), "a whole number of at least 0");
    if (!within(request.rate_hz, 0.0, kMostRate_hz))
        refuse_option("--rate", fmt::format("cannot be {:g} Hz", request.rate_hz),
                      fmt::format("greater than 0, at most {:g} Hz", kMostRate_hz));
    if (request.seconds * request.rate_hz > kMostSamples)
        refuse_option("--seconds",
                      fmt::format("{:g} s at {:g} Hz are too many samples", request.seconds, request.rate_hz),
                      fmt::format("at most {:g} s at this rate", std::floor(kMostSamples / request.rate_hz)));
    if (request.speed && !(*request.speed > 0.0 && *request.speed <= kHighestSpeed_m_per_s))
        refuse_option("--speed", fmt::format("cannot be {:g} m/s", *request.speed), "greater than 0, at most 200 m/s");
    if (!request.speed_profile.empty() && request.speed)
        refuse_option("--speed-profile", "the speed is given by --speed already", "--speed or --speed-profile");
    if (!within(request.noise, 0.0, 1000.0))
        refuse_option("--noise", fmt::format("cannot be {:g} m/s^2", request.noise), "between 0 and 1000 m/s^2");
    if (!within(request.speed_fluctuation, 0.0, 0.1))
        refuse_option("--speed-fluctuation", fmt::format("cannot be {:g}", request.speed_fluctuation),
                      "between 0 and 0.1");
    if (!within(request.profile_length_m, 0.0, 1e7))
        refuse_option("--profile-length", fmt::format("cannot be {:g} m", request.profile_length_m),
                      "between 0 and 1e7 m");
    if (!request.profile.empty() && (request.profile_seed || request.profile_length_m > 0.0))
        refuse_option("--profile", "a measured profile is not drawn",
                      "--profile, or --profile-seed and --profile-length");
}

Truth planned_simulation(const CaseFile& file, const SimulationRequest& request) {
    const std::vector<simulate::Hidden> hidden = read_hide_options(request.hide, request.force);
    const CaseWithHidden with = hide_in_case(file.parameters, hidden);
    const World world = read_world_option(request.world);
    if (!request.speed_profile.empty() && world.parameters.speed_end_m_per_s > 0.0)
        refuse_option("--world", "'speed_end_m_per_s' is a ramp from a constant speed",
                      "speed_end_m_per_s or --speed-profile");
    return {.case_path = request.path,
            .set_options = request.set,
            .hidden = hidden,
            .world = world.name(),
            .parameters = with.parameters,
            .options = simulation_options(request, world, with)};
}

simulate::Recording run_simulation(const CaseFile& file, const Truth& truth,
                                   const std::function<void(double, double)>& progress) {
    simulate::Options options = truth.options;
    options.progress = progress;
    try {
        return simulate::simulate(truth.parameters, options);
    } catch (const parameters::ParameterError& error) {
        if (error.key().starts_with("--")) refuse_option(error.key(), error.problem(), error.allowed());
        throw refused(file.document, error);
    }
}

}  // namespace railpem::app

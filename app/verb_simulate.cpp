#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/hide_option.hpp"
#include "app/output_folder.hpp"
#include "app/progress_bar.hpp"
#include "app/read_table.hpp"
#include "app/recording_schema.hpp"
#include "app/simulated_recording_files.hpp"
#include "app/truth_file.hpp"
#include "app/verbs.hpp"
#include "recordings/read_csv.hpp"
#include "simulate/simulate.hpp"

namespace railpem::app {

namespace fs = std::filesystem;

namespace {

struct SimulateRequest {
    std::string path;
    std::vector<std::string> hide, set;
    std::string folder, truth, format = "csv", profile;
    std::optional<double> seconds, speed;
    std::optional<std::int64_t> seed, profile_seed;
    double rate_hz = 1000.0, noise = 0.0, speed_fluctuation = 0.0, profile_length_m = 0.0;
    bool list = false, force = false, standing = false;
};

constexpr double kMostSeconds = 36000.0;   ///< ten hours: 2.6 GB of samples at 1 kHz
constexpr double kMostSamples = 5e7;       ///< per channel: 3.6 GB in nine
constexpr double kMostRate_hz = 100000.0;  ///< far beyond what a model of vehicle and track can say

[[noreturn]] void refuse(const std::string& option, const std::string& what, const std::string& allowed) {
    throw input_error("", "", {.option = option}, {.what = what, .allowed = allowed, .hint = ""});
}

void require(bool given, const std::string& option, const std::string& allowed) {
    if (!given) refuse("railpem simulate", option + " is required", allowed + "; railpem simulate --help says more");
}

void check_ranges(const SimulateRequest& request) {
    const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
    if (!within(*request.seconds, 0.0, kMostSeconds))
        refuse("--seconds", fmt::format("a record of {:g} s cannot be made", *request.seconds),
               fmt::format("at most {:g} s", kMostSeconds));
    for (const auto& [option, seed] :
         {std::pair("--seed", request.seed), std::pair("--profile-seed", request.profile_seed)})
        if (seed && *seed < 0) refuse(option, fmt::format("cannot be {}", *seed), "a whole number of at least 0");
    if (!within(request.rate_hz, 0.0, kMostRate_hz))
        refuse("--rate", fmt::format("cannot be {:g} Hz", request.rate_hz),
               fmt::format("greater than 0, at most {:g} Hz", kMostRate_hz));
    if (*request.seconds * request.rate_hz > kMostSamples)
        refuse("--seconds", fmt::format("{:g} s at {:g} Hz are too many samples", *request.seconds, request.rate_hz),
               fmt::format("at most {:g} s at this rate", std::floor(kMostSamples / request.rate_hz)));
    if (request.speed && !(*request.speed > 0.0 && *request.speed <= 200.0))
        refuse("--speed", fmt::format("cannot be {:g} m/s", *request.speed), "greater than 0, at most 200 m/s");
    if (!within(request.noise, 0.0, 1000.0))
        refuse("--noise", fmt::format("cannot be {:g} m/s^2", request.noise), "between 0 and 1000 m/s^2");
    if (!within(request.speed_fluctuation, 0.0, 0.1))
        refuse("--speed-fluctuation", fmt::format("cannot be {:g}", request.speed_fluctuation), "between 0 and 0.1");
    if (!within(request.profile_length_m, 0.0, 1e7))
        refuse("--profile-length", fmt::format("cannot be {:g} m", request.profile_length_m), "between 0 and 1e7 m");
    if (!request.profile.empty() && (request.profile_seed || request.profile_length_m > 0.0))
        refuse("--profile", "a measured profile is not drawn", "--profile, or --profile-seed and --profile-length");
}

simulate::MeasuredProfile read_profile(const std::string& path) {
    try {
        const recordings::DataTable table = recordings::read_csv(path, {"position_m", "height_m"});
        for (const std::vector<double>& column : table.columns)
            for (std::size_t i = 0; i < column.size(); ++i)
                if (!std::isfinite(column[i]) || (&column == &table.columns[0] && i > 0 && column[i] <= column[i - 1]))
                    refuse("--profile " + path,
                           fmt::format("value {} of {} is missing or out of order", i + 1,
                                       table.names[&column == &table.columns[0] ? 0 : 1]),
                           "increasing positions, every height known");
        return {table.columns[0], table.columns[1]};
    } catch (const recordings::ReadError& error) {
        throw refused(error);
    }
}

simulate::Options simulation_options(const SimulateRequest& request, const CaseWithHidden& with) {
    simulate::Options options;
    options.mode = request.standing ? simulate::Mode::standing : simulate::Mode::moving;
    options.seconds = *request.seconds;
    options.sampling_rate_hz = request.rate_hz;
    options.speed_m_per_s = request.speed.value_or(0.0);
    options.seed = static_cast<std::uint64_t>(*request.seed);
    if (request.profile_seed) options.profile_seed = static_cast<std::uint64_t>(*request.profile_seed);
    options.profile_length_m = request.profile_length_m;
    if (!request.profile.empty()) options.measured_profile = read_profile(request.profile);
    options.speed_fluctuation = request.speed_fluctuation;
    options.noise_rms_m_per_s2 = request.noise;
    options.only_here = with.only_here;
    return options;
}

simulate::Recording run_simulation(const CaseFile& file, const Truth& truth) {
    ProgressBar bar(file.name);
    simulate::Options options = truth.options;
    constexpr double kParts = 1000.0;  // of a second, for a bar that counts in whole numbers
    options.progress = [&](double done_s, double total_s) {
        bar.show(static_cast<std::size_t>(done_s * kParts), static_cast<std::size_t>(total_s * kParts));
    };
    try {
        return simulate::simulate(truth.parameters, options);
    } catch (const parameters::ParameterError& error) {
        if (error.key().starts_with("--")) refuse(error.key(), error.problem(), error.allowed());
        throw refused(file.document, error);
    }
}

/// The truth may lie anywhere but in the place of the recording itself.
void check_truth_path(const SimulateRequest& request) {
    std::error_code ignored;
    for (const char* name : {"recording.toml", "recording.csv", "recording.mat", "recording.h5"})
        if (fs::weakly_canonical(request.truth, ignored) ==
            fs::weakly_canonical(fs::path(request.folder) / name, ignored))
            refuse("--truth " + request.truth, "would overwrite the recording", "another file");
    if (fs::is_directory(request.truth, ignored) || fs::path(request.truth).filename().empty())
        refuse("--truth " + request.truth, "is a folder", "a file");
}

RecordingFormat format_of(const std::string& name) {
    return name == "mat" ? RecordingFormat::mat : name == "hdf5" ? RecordingFormat::hdf5 : RecordingFormat::csv;
}

int list_effects() {
    std::fputs(effects_list().c_str(), stdout);
    return 0;
}

int simulate_recording(const SimulateRequest& request) {
    if (request.list) return list_effects();
    require(!request.path.empty(), "CASE", "a case file");
    require(request.seconds.has_value(), "--seconds", "--seconds T, the length of the record in s");
    require(request.seed.has_value(), "--seed", "--seed N, which draws track and noise");
    require(!request.folder.empty(), "--out", "--out DIR, the folder for the recording");
    check_ranges(request);
    if (!request.truth.empty()) check_truth_path(request);
    const CaseFile file = read_case(request.path, request.set);
    const std::vector<simulate::Hidden> hidden = read_hide_options(request.hide, request.force);
    const CaseWithHidden with = hide_in_case(file.parameters, hidden);
    const Truth truth{.case_path = request.path,
                      .set_options = request.set,
                      .hidden = hidden,
                      .parameters = with.parameters,
                      .options = simulation_options(request, with)};

    OutputFolder folder(request.folder);
    std::optional<OutputFolder> truth_folder;
    if (!request.truth.empty()) truth_folder.emplace(fs::path(request.truth).parent_path(), "--truth");
    const simulate::Recording recording = run_simulation(file, truth);
    write_simulated_recording(folder, recording, format_of(request.format));
    if (truth_folder) truth_folder->write(fs::path(request.truth).filename().string(), truth_text(truth, recording));
    folder.commit();
    if (truth_folder) truth_folder->commit();
    return 0;
}

void add_profile_options(CLI::App& verb, SimulateRequest& request) {
    verb.add_option("--profile", request.profile,
                    "measured profile instead of a drawn one: CSV with position_m, height_m (up positive)")
        ->type_name("FILE");
    verb.add_option(
            "--profile-seed", request.profile_seed,
            "draws the track alone: records with the same --profile-seed and --profile-length run over the same line")
        ->type_name("N");
    verb.add_option("--profile-length", request.profile_length_m,
                    "length in m of the line that is drawn; without it as long as the record needs")
        ->type_name("M");
}

}  // namespace

void add_simulate(CLI::App& program, Run& run) {
    const auto request = std::make_shared<SimulateRequest>();
    CLI::App* verb = program.add_subcommand(
        "simulate",
        "a recording marched in time, with or without hidden effects: DIR/recording.toml and DIR/recording.csv");
    verb->add_option("CASE", request->path, "case file");
    verb->add_option("--hide", request->hide, "conceal an effect in it: EFFECT[:parameter=value,…]; may be repeated")
        ->type_name("EFFECT")
        ->allow_extra_args(false);
    verb->add_option("--seconds", request->seconds, "length of the record in s")->type_name("T");
    verb->add_option("--seed", request->seed, "draws track and noise; the same seed gives the same bits")
        ->type_name("N");
    verb->add_option("--out", request->folder, "folder for the recording")->type_name("DIR");
    verb->add_option("--truth", request->truth,
                     "file for what is hidden and how the record was made (JSON); nothing says it elsewhere")
        ->type_name("FILE");
    verb->add_flag("--list", request->list, "print all effects with their parameters and ranges, and do nothing else");
    verb->add_flag("--force", request->force,
                   "let the parameters of effects lie outside their ranges; the truth says so");
    verb->add_option("--rate", request->rate_hz, "sampling rate in Hz; 1000 without it")->type_name("HZ");
    verb->add_option("--format", request->format,
                     "csv, or also mat or hdf5: full precision, and what recording.toml names")
        ->check(CLI::IsMember({"csv", "mat", "hdf5"}))
        ->type_name("FORMAT");
    verb->add_flag("--standing", request->standing,
                   "the wheels stand and the irregularity is pulled through under them");
    verb->add_option("--speed", request->speed, "speed in m/s; without it the first of the case")->type_name("M_PER_S");
    verb->add_option("--speed-fluctuation", request->speed_fluctuation,
                     "relative standard deviation of a slow wander of the speed")
        ->type_name("R");
    verb->add_option("--noise", request->noise, "white noise of every channel, rms in m/s^2")->type_name("RMS");
    add_profile_options(*verb, *request);
    verb->add_option("--set", request->set, "override a key of the case: key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->callback([request, &run] { run = [request] { return simulate_recording(*request); }; });
}

}  // namespace railpem::app

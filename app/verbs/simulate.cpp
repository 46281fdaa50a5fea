#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/output_folder.hpp"
#include "app/progress_bar.hpp"
#include "app/schema/hide_option.hpp"
#include "app/schema/world_option.hpp"
#include "app/tables/simulated_recording_files.hpp"
#include "app/verbs/simulation_request.hpp"
#include "app/verbs/verbs.hpp"
#include "effects/catalogue.hpp"
#include "track/causal_losses.hpp"

namespace railpem::app {

namespace fs = std::filesystem;

namespace {

struct SimulateRequest {
    SimulationRequest simulation;
    std::string folder, truth, format = "csv";
    std::optional<double> seconds;
    std::optional<std::int64_t> seed;
    bool list = false;
};

void require(bool given, const std::string& option, const std::string& allowed) {
    if (!given)
        refuse_option("railpem simulate", option + " is required", allowed + "; railpem simulate --help says more");
}

simulate::Recording run_with_bar(const CaseFile& file, const Truth& truth) {
    ProgressBar bar(file.name);
    constexpr double kParts = 1000.0;  // of a second, for a bar that counts in whole numbers
    return run_simulation(file, truth, [&](double done_s, double total_s) {
        bar.show(static_cast<std::size_t>(done_s * kParts), static_cast<std::size_t>(total_s * kParts));
    });
}

/// The truth may lie anywhere but in the place of the recording itself.
void check_truth_path(const SimulateRequest& request) {
    std::error_code ignored;
    for (const char* name : {"recording.toml", "recording.csv", "recording.mat", "recording.h5"})
        if (fs::weakly_canonical(request.truth, ignored) ==
            fs::weakly_canonical(fs::path(request.folder) / name, ignored))
            refuse_option("--truth " + request.truth, "would overwrite the recording", "another file");
    if (fs::is_directory(request.truth, ignored) || fs::path(request.truth).filename().empty())
        refuse_option("--truth " + request.truth, "is a folder", "a file");
    if (fs::exists(request.truth, ignored) && !fs::is_regular_file(request.truth, ignored))
        refuse_option("--truth " + request.truth, "is a device or a pipe", "a file");
}

RecordingFormat format_of(const std::string& name) {
    return name == "mat" ? RecordingFormat::mat : name == "hdf5" ? RecordingFormat::hdf5 : RecordingFormat::csv;
}

int list_effects() {
    std::fputs((effects_list() + world_list()).c_str(), stdout);
    return 0;
}

int simulate_recording(const SimulateRequest& request) {
    if (request.list) return list_effects();
    SimulationRequest simulation = request.simulation;
    require(!simulation.path.empty(), "CASE", "a case file");
    require(request.seconds.has_value(), "--seconds", "--seconds T, the length of the record in s");
    require(request.seed.has_value(), "--seed", "--seed N, which draws track and noise");
    require(!request.folder.empty(), "--out", "--out DIR, the folder for the recording");
    simulation.seconds = *request.seconds;
    simulation.seed = *request.seed;
    check_simulation(simulation);
    if (!request.truth.empty()) check_truth_path(request);
    const CaseFile file = read_case(simulation.path, simulation.set);
    const Truth truth = planned_simulation(file, simulation);
    for (const std::string& part : track::constant_losses(file.parameters.track))
        fmt::print(stderr, "note: a constant loss factor is no motion in time: {} are marched with a causal law\n",
                   part);

    // What is hidden stands in the truth and nowhere else, so that a recording names the program and no command.
    const Writing results = results_of_run(simulation.force);
    OutputFolder folder(request.folder, "--out", {results.overwrite, program_provenance});
    std::optional<OutputFolder> truth_folder;
    if (!request.truth.empty()) {
        truth_folder.emplace(fs::path(request.truth).parent_path(), "--truth", results);
        truth_folder->claim(fs::path(request.truth).filename().string());
    }
    for (const std::string& name : recording_files(format_of(request.format))) folder.claim(name);
    const simulate::Recording recording = run_with_bar(file, truth);
    write_simulated_recording(folder, recording, format_of(request.format));
    if (truth_folder) truth_folder->write(fs::path(request.truth).filename().string(), truth_text(truth, recording));
    folder.commit();
    if (truth_folder) truth_folder->commit();
    return 0;
}

void add_profile_options(CLI::App& verb, SimulateRequest& request) {
    verb.add_option("--profile", request.simulation.profile,
                    "measured profile instead of a drawn one: CSV with position_m, height_m (up positive)")
        ->type_name("FILE");
    verb.add_option(
            "--profile-seed", request.simulation.profile_seed,
            "draws the track alone: records with the same --profile-seed and --profile-length run over the same line")
        ->type_name("N");
    verb.add_option("--profile-length", request.simulation.profile_length_m,
                    "length in m of the line that is drawn; without it as long as the record needs")
        ->type_name("M");
}

void add_world_options(CLI::App& verb, SimulateRequest& request) {
    verb.add_option("--world", request.simulation.world,
                    "ideal, good or worn: speed, seats, line and sensors as imperfect as that; ideal without it")
        ->type_name("GRADE[:key=value,…]");
    verb.add_option("--speed-profile", request.simulation.speed_profile,
                    "speed against time instead of --speed: CSV with time_s, speed_m_per_s; 0 is a stop")
        ->type_name("FILE");
    verb.add_flag("--speed-channel", request.simulation.speed_channel, "record the speed, too");
}

}  // namespace

void add_simulate(CLI::App& program, Run& run) {
    const auto request = std::make_shared<SimulateRequest>();
    CLI::App* verb = program.add_subcommand(
        "simulate",
        "a recording marched in time, with or without hidden effects: DIR/recording.toml and DIR/recording.csv");
    const effects::EffectDescription& first = effects::catalogue().front();
    verb->footer(
        fmt::format("Examples:\n"
                    "  railpem simulate --list\n"
                    "  railpem simulate case.toml --seconds 60 --seed 1 --out run1 --truth run1.json --hide {}:{}={:g}",
                    first.id, first.parameters.front().name, first.parameters.front().typical));
    verb->add_option("CASE", request->simulation.path, "case file");
    verb->add_option("--hide", request->simulation.hide,
                     "conceal an effect in it: EFFECT[:parameter=value,…]; may be repeated")
        ->type_name("EFFECT")
        ->allow_extra_args(false);
    verb->add_option("--seconds", request->seconds, "length of the record in s; required")->type_name("T");
    verb->add_option("--seed", request->seed, "draws track and noise; the same seed gives the same bits; required")
        ->type_name("N");
    verb->add_option("--out", request->folder, "folder for the recording; required")->type_name("DIR");
    verb->add_option("--truth", request->truth,
                     "file for what is hidden and how the record was made (JSON); nothing says it elsewhere")
        ->type_name("FILE");
    verb->add_flag(
        "--list", request->list,
        "print all effects with their parameters and ranges and the numbers of a world, and do nothing else");
    verb->add_flag(
        "--force", request->simulation.force,
        "let the parameters of effects lie outside their ranges, of which the truth tells; and write over files that "
        "this program did not write, never over an input of the run");
    verb->add_option("--rate", request->simulation.rate_hz, "sampling rate in Hz; 1000 without it")->type_name("HZ");
    verb->add_option("--format", request->format,
                     "csv, or also mat or hdf5: full precision, and what recording.toml names")
        ->check(CLI::IsMember({"csv", "mat", "hdf5"}))
        ->type_name("FORMAT");
    verb->add_flag("--standing", request->simulation.standing,
                   "the wheels stand and the irregularity is pulled through under them");
    verb->add_option("--speed", request->simulation.speed, "speed in m/s; without it the first of the case")
        ->type_name("M_PER_S");
    verb->add_option("--speed-fluctuation", request->simulation.speed_fluctuation,
                     "relative standard deviation of a slow wander of the speed")
        ->type_name("R");
    add_world_options(*verb, *request);
    verb->add_option("--noise", request->simulation.noise, "white noise of every channel, rms in m/s^2")
        ->type_name("RMS");
    add_profile_options(*verb, *request);
    verb->add_option("--set", request->simulation.set, "override a key of the case: key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->callback([request, &run] { run = [request] { return simulate_recording(*request); }; });
}

}  // namespace railpem::app

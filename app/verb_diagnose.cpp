#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <set>

#include "app/diagnosed_case.hpp"
#include "app/diagnosis_inputs.hpp"
#include "app/diagnosis_json.hpp"
#include "app/diagnosis_report.hpp"
#include "app/diagnosis_tables.hpp"
#include "app/input_error.hpp"
#include "app/inspection_beliefs.hpp"
#include "app/interrupt_guard.hpp"
#include "app/output_folder.hpp"
#include "app/progress_bar.hpp"
#include "app/verbs.hpp"
#include "diagnosis/diagnose.hpp"
#include "diagnosis/observe_scalars.hpp"
#include "recordings/inspection.hpp"

namespace railpem::app {

namespace {

struct DiagnoseRequest {
    std::string case_path, folder;
    std::vector<std::string> recordings, set;
    double window_s = 4.0, held_out = 0.25;
    int threads = 0, most_effects = 3;
};

struct LoadedRecordings {
    std::vector<diagnosis::Observation> observations;
    std::vector<std::vector<std::string>> faults;             ///< per observation
    std::vector<std::vector<std::string>> channels_not_used;  ///< per observation
    std::vector<bool> irregularity_measured;                  ///< per observation
    std::vector<recordings::MeasuredIrregularity> irregularity;

    void add(const diagnosis::Observation& observation, std::vector<std::string> own_faults, std::vector<std::string> not_used) {
        observations.push_back(observation);
        faults.push_back(std::move(own_faults));
        channels_not_used.push_back(std::move(not_used));
    }
};

/// Channels of spectra that the case does not have.
std::vector<std::string> unused_spectra(const recordings::Recording& recording, const diagnosis::Observation& observation) {
    std::vector<std::string> names;
    for (const recordings::ChannelSpectrum& spectrum : recording.spectra)
        if (std::find(observation.channel_names.begin(), observation.channel_names.end(), spectrum.description.name) == observation.channel_names.end())
            names.push_back(spectrum.description.name);
    return names;
}

/// Recordings that are the same file twice would count the same evidence twice.
void check_distinct(const DiagnoseRequest& request) {
    std::set<std::string> seen;
    std::error_code ignored;
    for (const std::string& path : request.recordings)
        if (!seen.insert(std::filesystem::weakly_canonical(path, ignored).string()).second)
            throw InputError(fmt::format("{}: the same recording twice would count its evidence twice\nallowed: each recording once", path));
}

LoadedRecordings load_recordings(const DiagnoseRequest& request, const CaseFile& file, const diagnosis::BelievedCase& believed) {
    LoadedRecordings loaded;
    std::set<std::string> data_files;
    for (const std::string& path : request.recordings) {
        const RecordingFile description = read_recording(path);
        const recordings::Recording recording = load_recording(description);
        if (!data_files.insert(std::filesystem::weakly_canonical(recording.file).string()).second)
            throw InputError(fmt::format("{}: the same data file twice would count its evidence twice\nallowed: data of its own for each recording", path));
        loaded.irregularity_measured.push_back(recording.irregularity.brought());
        if (recording.irregularity.brought()) loaded.irregularity.push_back(recording.irregularity);
        const diagnosis::ObservationOptions options{.window_s = request.window_s, .held_out_share = request.held_out};
        const bool series = recording.description.kind == recordings::RecordingKind::timeseries;
        const auto observation = reading_data(description, [&] {
            return series ? diagnosis::observe(recording, description.name, believed.numbers, options)
                          : diagnosis::observe_scalars(recording, description.name, believed.numbers, options);
        });
        if (!series) {  // nothing to inspect: what it lacks is part of what the verdict rests on
            loaded.add(observation, {}, unused_spectra(recording, observation));
            continue;
        }
        const recordings::InspectionReport inspection = recordings::inspect(recording, inspection_beliefs(file, description));
        std::vector<std::string> faults, not_used;
        for (const recordings::Fault& fault : inspection.faults) {
            if (fault.severity != recordings::Severity::note) faults.push_back(fault.says);
            if (fault.severity != recordings::Severity::error) continue;
            // At another speed nothing lies where it is looked for, and no fit would come near.
            if (fault.kind == recordings::FaultKind::speed_mismatch) throw InputError(fmt::format("{}: {}\nallowed: the speed of the record, in m/s", path, fault.says));
            fmt::print(stderr, "{}: {}\n", path, fault.says);
        }
        for (const recordings::Channel& channel : recording.series.channels)
            if (std::find(observation.channel_names.begin(), observation.channel_names.end(), channel.description.name) == observation.channel_names.end())
                not_used.push_back(channel.description.name);
        loaded.add(observation, std::move(faults), std::move(not_used));
    }
    return loaded;
}

std::string command_of(const DiagnoseRequest& request) {
    std::string text = "railpem diagnose " + request.case_path;
    for (const std::string& path : request.recordings) text += " " + path;
    for (const std::string& option : request.set) text += " --set '" + option + "'";
    const DiagnoseRequest usual;
    if (request.window_s != usual.window_s) text += fmt::format(" --window {:g}", request.window_s);
    if (request.held_out != usual.held_out) text += fmt::format(" --held-out {:g}", request.held_out);
    if (request.most_effects != usual.most_effects) text += fmt::format(" --most-effects {}", request.most_effects);
    return text + " --out " + request.folder;
}

void write_results(OutputFolder& folder, const diagnosis::Diagnosis& result, const DiagnoseRequest& request) {
    folder.write("diagnosis.json", diagnosis_json(result));
    for (const TextFile& table : diagnosis_tables(result)) folder.write(table.name, table.text);
    folder.write("report.html", diagnosis_report(result, command_of(request)));
    folder.write(kDiagnosedIrregularity, irregularity_text(result.diagnosed_numbers));
    folder.write("diagnosed.toml", diagnosed_case_text(result));
}

int diagnose(const DiagnoseRequest& request) {
    check_distinct(request);
    const CaseFile file = read_case(request.case_path, request.set);
    diagnosis::BelievedCase believed = believed_case(file);
    const LoadedRecordings loaded = load_recordings(request, file, believed);
    believed.measured_irregularity = loaded.irregularity;
    OutputFolder folder(request.folder);
    const InterruptGuard guard;
    ProgressBar bar(file.name);
    diagnosis::DiagnoseOptions options{.threads = request.threads};
    options.naming.most_effects = request.most_effects;
    options.progress = [&](const std::string&, double share) { bar.show(static_cast<std::size_t>(1000.0 * share), 1000); };
    options.interrupted = InterruptGuard::asked;
    diagnosis::Diagnosis result = diagnosis::diagnose(believed, loaded.observations, options);
    for (std::size_t o = 0; o < result.recordings.size(); ++o) {
        result.recordings[o].faults = loaded.faults[o];
        result.recordings[o].irregularity_measured = loaded.irregularity_measured[o];
        result.recordings[o].channels_not_used = loaded.channels_not_used[o];
    }
    write_results(folder, result, request);
    folder.commit();
    fmt::print("{}{}\n{}\n{}\n", diagnosis::verdict_name(result.verdict), result.interrupted ? " (interrupted)" : "", result.statement,
               (folder.path() / "report.html").string());
    return 0;
}

}  // namespace

void add_diagnose(CLI::App& program, Run& run) {
    const auto request = std::make_shared<DiagnoseRequest>();
    CLI::App* verb = program.add_subcommand(
        "diagnose", "what a believed case left out, told from recordings: DIR/diagnosis.json, DIR/report.html, DIR/diagnosed.toml and spectra");
    verb->add_option("CASE", request->case_path, "the case that was believed")->required();
    verb->add_option("RECORDING", request->recordings, "recordings of the same vehicle and track, several speeds or loads together")->required();
    verb->add_option("--out", request->folder, "folder for the results")->required()->type_name("DIR");
    verb->add_option("--window", request->window_s, "length of a segment in s; 4 without it")->check(CLI::Range(0.25, 60.0))->type_name("S");
    verb->add_option("--held-out", request->held_out, "share of the end of every record that no fit sees; 0.25 without it")
        ->check(CLI::Range(0.1, 0.5))
        ->type_name("SHARE");
    verb->add_option("--most-effects", request->most_effects, "most effects named together; 3 without it")->check(CLI::Range(1, 4))->type_name("N");
    verb->add_option("--threads", request->threads, "threads; all without it")->check(CLI::Range(1, 1024))->type_name("N");
    verb->add_option("--set", request->set, "override a key of the case: key=value")->type_name("KEY=VALUE")->allow_extra_args(false);
    verb->callback([request, &run] { run = [request] { return diagnose(*request); }; });
}

}  // namespace railpem::app

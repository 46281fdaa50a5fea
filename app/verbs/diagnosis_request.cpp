#include "app/verbs/diagnosis_request.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <set>
#include <utility>

#include "app/input_error.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/schema/diagnosed_case.hpp"
#include "app/schema/diagnosis_inputs.hpp"
#include "app/schema/nearest_key.hpp"
#include "app/schema/schema.hpp"
#include "app/tables/diagnosis_json.hpp"
#include "app/tables/diagnosis_tables.hpp"
#include "app/verbs/inspection_beliefs.hpp"
#include "diagnosis/diagnose.hpp"
#include "diagnosis/likelihood/hold_out_recordings.hpp"
#include "diagnosis/observations/observe.hpp"
#include "diagnosis/observations/observe_scalars.hpp"
#include "diagnosis/observations/rail_sides.hpp"
#include "pem/threads.hpp"
#include "recordings/inspection/inspection.hpp"

namespace railpem::app {

namespace {

struct LoadedRecordings {
    std::vector<diagnosis::Observation> observations;
    std::vector<std::vector<std::string>> faults;             ///< per observation
    std::vector<std::vector<std::string>> channels_not_used;  ///< per observation
    std::vector<bool> irregularity_measured;                  ///< per observation
    std::vector<recordings::MeasuredIrregularity> irregularity;

    void add(const diagnosis::Observation& observation, std::vector<std::string> own_faults,
             std::vector<std::string> not_used) {
        observations.push_back(observation);
        faults.push_back(std::move(own_faults));
        channels_not_used.push_back(std::move(not_used));
    }

    void append(LoadedRecordings other) {
        const auto move_to = [](auto& from, auto& to) {
            to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
        };
        move_to(other.observations, observations);
        move_to(other.faults, faults);
        move_to(other.channels_not_used, channels_not_used);
        move_to(other.irregularity_measured, irregularity_measured);
        move_to(other.irregularity, irregularity);
    }
};

/// Channels of spectra that the case does not have.
std::vector<std::string> unused_spectra(const recordings::Recording& recording,
                                        const diagnosis::Observation& observation) {
    std::vector<std::string> names;
    for (const recordings::ChannelSpectrum& spectrum : recording.spectra)
        if (std::find(observation.channel_names.begin(), observation.channel_names.end(), spectrum.description.name) ==
            observation.channel_names.end())
            names.push_back(spectrum.description.name);
    return names;
}

/// Recordings that are the same file twice would count the same evidence twice.
void check_distinct(const DiagnosisRequest& request) {
    std::set<std::string> seen;
    std::error_code ignored;
    for (const std::string& path : request.recordings)
        if (!seen.insert(std::filesystem::weakly_canonical(path, ignored).string()).second)
            throw InputError(fmt::format(
                "{}: the same recording twice would count its evidence twice\nallowed: each recording once", path));
}

void check_without(const DiagnosisRequest& request) {
    std::vector<std::string> known;
    for (const diagnosis::Effect& effect : diagnosis::effects()) known.push_back(effect.id);
    for (const std::string& id : request.without) {
        if (std::find(known.begin(), known.end(), id) == known.end())
            throw unknown_name("--without", "effect", id, known);
    }
}

/// A time series, one rail after the other where it has channels of both.
void add_series(const recordings::Recording& recording, const RecordingFile& description, const std::string& path,
                const CaseFile& file, const diagnosis::BelievedCase& believed,
                const diagnosis::ObservationOptions& options, LoadedRecordings& loaded) {
    const std::vector<diagnosis::SideRecording> sides = diagnosis::one_rail_each(recording);
    std::vector<diagnosis::Observation> observations;
    std::vector<std::string> used;
    for (const diagnosis::SideRecording& side : sides) {
        observations.push_back(reading_data(description, [&] {
            return diagnosis::observe(side.recording, description.name + side.suffix, believed.numbers, options);
        }));
        used.insert(used.end(), observations.back().channel_names.begin(), observations.back().channel_names.end());
    }
    const recordings::InspectionReport inspection =
        recordings::inspect(recording, inspection_beliefs(file, description));
    std::vector<std::string> faults, not_used;
    for (const recordings::Fault& fault : inspection.faults) {
        if (fault.severity != recordings::Severity::note)
            faults.push_back(
                fmt::format("{}{}{}", fmt::join(fault.channels, ", "), fault.channels.empty() ? "" : ": ", fault.says));
        // At another speed nothing lies where it is looked for, and no fit would come near.
        if (fault.kind == recordings::FaultKind::speed_mismatch && fault.severity == recordings::Severity::error)
            throw InputError(fmt::format("{}: {}\nallowed: the speed of the record, in m/s", path, fault.says));
    }
    for (const recordings::Channel& channel : recording.series.channels)
        if (std::find(used.begin(), used.end(), channel.description.name) == used.end())
            not_used.push_back(channel.description.name);
    for (const diagnosis::Observation& observation : observations) {
        loaded.irregularity_measured.push_back(recording.irregularity.brought());
        loaded.add(observation, faults, not_used);
    }
}

/// What is on disk of a recording.
struct ReadRecording {
    std::string path;
    RecordingFile description;
    recordings::Recording recording;
};

std::vector<ReadRecording> read_recordings(const DiagnosisRequest& request) {
    std::vector<ReadRecording> read;
    std::set<std::string> data_files;
    for (const std::string& path : request.recordings) {
        RecordingFile description = read_recording(path);
        recordings::Recording recording = load_recording(description);
        if (!data_files.insert(std::filesystem::weakly_canonical(recording.file).string()).second)
            throw InputError(
                fmt::format("{}: the same data file twice would count its evidence twice\nallowed: data of its own for "
                            "each recording",
                            path));
        read.push_back({path, std::move(description), std::move(recording)});
    }
    return read;
}

/// What a diagnosis needs of it; the samples are let go.
LoadedRecordings loaded_from(ReadRecording& own, const DiagnosisRequest& request, const CaseFile& file,
                             const diagnosis::BelievedCase& believed) {
    LoadedRecordings loaded;
    if (own.recording.irregularity.brought()) loaded.irregularity.push_back(own.recording.irregularity);
    const diagnosis::ObservationOptions options{.window_s = request.window_s, .held_out_share = request.held_out};
    if (own.recording.description.kind == recordings::RecordingKind::timeseries) {
        add_series(own.recording, own.description, own.path, file, believed, options, loaded);
        own.recording = {};
        return loaded;
    }
    // Nothing to inspect: what it lacks is part of what the verdict rests on.
    const auto observation = reading_data(own.description, [&] {
        return diagnosis::observe_scalars(own.recording, own.description.name, believed.numbers, options);
    });
    loaded.irregularity_measured.push_back(own.recording.irregularity.brought());
    loaded.add(observation, {}, unused_spectra(own.recording, observation));
    return loaded;
}

/// Read one after the other, for not every library that reads is safe between threads; looked at side by side.
LoadedRecordings load_recordings(const DiagnosisRequest& request, const CaseFile& file,
                                 const diagnosis::BelievedCase& believed) {
    std::vector<ReadRecording> read = read_recordings(request);
    std::vector<LoadedRecordings> parts(read.size());
    std::vector<std::exception_ptr> failures(read.size());  // of each: the same one is reported whichever comes first
#pragma omp parallel for schedule(dynamic, 1) num_threads(pem::thread_count(request.threads))
    for (std::size_t i = 0; i < read.size(); ++i) try {
            parts[i] = loaded_from(read[i], request, file, believed);
        } catch (...) {
            failures[i] = std::current_exception();
        }
    LoadedRecordings loaded;
    for (std::size_t i = 0; i < read.size(); ++i) {
        if (failures[i]) std::rethrow_exception(failures[i]);
        loaded.append(std::move(parts[i]));
    }
    diagnosis::hold_out_recordings(loaded.observations);
    return loaded;
}

}  // namespace

diagnosis::Diagnosis run_diagnosis(const CaseFile& file, const DiagnosisRequest& request,
                                   const DiagnosisObserver& observer, const std::function<void()>& ready) {
    check_distinct(request);
    check_without(request);
    diagnosis::BelievedCase believed = believed_case(file);
    const LoadedRecordings loaded = load_recordings(request, file, believed);
    believed.measured_irregularity = loaded.irregularity;
    ready();
    diagnosis::DiagnoseOptions options{.threads = request.threads};
    options.naming.most_effects = request.most_effects;
    options.naming.without = request.without;
    options.naming.effort_s = request.effort_s;
    options.progress = [&](const std::string&, double share) { observer.progress(share); };
    options.interrupted = observer.interrupted;
    diagnosis::Diagnosis result = diagnosis::diagnose(believed, loaded.observations, options);
    std::size_t loaded_at = 0;  // in the same order, some left out
    for (auto& own : result.recordings) {
        while (loaded.observations[loaded_at].name != own.name) ++loaded_at;
        own.faults = loaded.faults[loaded_at];
        own.irregularity_measured = loaded.irregularity_measured[loaded_at];
        own.channels_not_used = loaded.channels_not_used[loaded_at];
        ++loaded_at;
    }
    return result;
}

void write_diagnosis(OutputFolder& folder, const diagnosis::Diagnosis& result, const DiagnosisRequest& request) {
    folder.write("diagnosis.json", diagnosis_json(result));
    for (const TextFile& table : diagnosis_tables(result)) folder.write(table.name, table.text);
    folder.write("report.html", diagnosis_report(result, command_of(request, folder.path().string())));
    folder.write(kDiagnosedIrregularity, irregularity_text(result.diagnosed_numbers));
    folder.write("diagnosed.toml", diagnosed_case_text(result));
}

std::string command_of(const DiagnosisRequest& request, const std::string& folder) {
    std::string text = "railpem diagnose " + request.case_path;
    for (const std::string& path : request.recordings) text += " " + path;
    for (const std::string& option : request.set) text += " --set '" + option + "'";
    const DiagnosisRequest usual;
    if (request.window_s != usual.window_s) text += fmt::format(" --window {:g}", request.window_s);
    if (request.held_out != usual.held_out) text += fmt::format(" --held-out {:g}", request.held_out);
    if (request.most_effects != usual.most_effects) text += fmt::format(" --most-effects {}", request.most_effects);
    if (request.effort_s != usual.effort_s) text += fmt::format(" --effort {:g}", request.effort_s);
    for (const std::string& effect : request.without) text += " --without " + effect;
    return text + " --out " + folder;
}

}  // namespace railpem::app

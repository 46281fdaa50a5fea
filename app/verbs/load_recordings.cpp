#include "app/verbs/load_recordings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iterator>
#include <set>
#include <utility>

#include "app/input_error.hpp"
#include "app/schema/recording_schema.hpp"
#include "app/verbs/inspection_beliefs.hpp"
#include "diagnosis/likelihood/hold_out_recordings.hpp"
#include "diagnosis/observations/observe.hpp"
#include "diagnosis/observations/observe_scalars.hpp"
#include "diagnosis/observations/rail_sides.hpp"
#include "pem/threads.hpp"
#include "recordings/inspection/inspect.hpp"

namespace railpem::app {

namespace {

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

/// Where delays between axle boxes or bogies contradict the stated speed, they win: at another speed nothing lies where
/// it is looked for. Not where the description says how sure its speed is. Throws InputError then.
void take_speed_of_delays(const recordings::InspectionReport& inspection, const std::string& path,
                          recordings::RecordingDescription& description) {
    for (const recordings::Fault& fault : inspection.faults) {
        if (fault.kind != recordings::FaultKind::speed_mismatch || fault.severity != recordings::Severity::error)
            continue;
        if (description.speed_standard_error_m_per_s > 0.0 || !(inspection.speed_m_per_s > 0.0))
            throw InputError(
                fmt::format("{}: {}\nallowed: the speed of the record, in m/s, or no standard error: then "
                            "the delays count",
                            path, fault.says));
        description.speed_m_per_s = inspection.speed_m_per_s;
        description.speed_standard_error_m_per_s = inspection.speed_error_m_per_s;
        return;
    }
}

/// A time series, one rail after the other where it has channels of both.
void add_series(const recordings::Recording& recording, const RecordingFile& description, const std::string& path,
                const CaseFile& file, const diagnosis::BelievedCase& believed,
                const diagnosis::ObservationOptions& options, LoadedRecordings& loaded) {
    const recordings::InspectionReport inspection =
        recordings::inspect(recording, inspection_beliefs(file, description));
    std::vector<diagnosis::SideRecording> sides = diagnosis::one_rail_each(recording);
    std::vector<diagnosis::Observation> observations;
    std::vector<std::string> used, faults, not_used;
    for (diagnosis::SideRecording& side : sides) {
        take_speed_of_delays(inspection, path, side.recording.description);
        for (diagnosis::Observation& own : reading_data(description, [&] {
                 return diagnosis::observe(side.recording, description.name + side.suffix, believed.numbers, options);
             }))
            observations.push_back(std::move(own));
        used.insert(used.end(), observations.back().channel_names.begin(), observations.back().channel_names.end());
    }
    for (const recordings::Fault& fault : inspection.faults) {
        if (fault.severity != recordings::Severity::note)
            faults.push_back(
                fmt::format("{}{}{}", fmt::join(fault.channels, ", "), fault.channels.empty() ? "" : ": ", fault.says));
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
    std::vector<std::string> faults;
    for (const recordings::Fault& fault : own.recording.contradictions)
        faults.push_back(fmt::format("{}: {}", fmt::join(fault.channels, ", "), fault.says));
    loaded.add(observation, faults, unused_spectra(own.recording, observation));
    return loaded;
}

}  // namespace

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

}  // namespace railpem::app

#include "app/verbs/run_diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/input_error.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/schema/believed_case.hpp"
#include "app/schema/diagnosed_case.hpp"
#include "app/schema/nearest_key.hpp"
#include "app/tables/diagnosis_json.hpp"
#include "app/tables/diagnosis_tables.hpp"
#include "app/verbs/load_recordings.hpp"
#include "diagnosis/diagnose.hpp"

namespace railpem::app {

namespace {

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

/// What reading and inspecting has shown, beside what the diagnosis has made of it.
void describe_recordings(const LoadedRecordings& loaded, diagnosis::Diagnosis& result) {
    std::size_t loaded_at = 0;  // in the same order, some left out
    for (auto& own : result.recordings) {
        while (loaded.observations[loaded_at].name != own.name) ++loaded_at;
        own.faults = loaded.faults[loaded_at];
        own.irregularity_measured = loaded.irregularity_measured[loaded_at];
        own.channels_not_used = loaded.channels_not_used[loaded_at];
        ++loaded_at;
    }
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
    describe_recordings(loaded, result);
    return result;
}

void write_diagnosis(OutputFolder& folder, const diagnosis::Diagnosis& result, const DiagnosisRequest& request) {
    folder.write("diagnosis.json", diagnosis_json(result, request.doubts));
    for (const TextFile& table : diagnosis_tables(result)) folder.write(table.name, table.text);
    folder.write("report.html", diagnosis_report(result, {.command = command_of(request, folder.path().string()),
                                                          .doubts = request.doubts,
                                                          .provenance = folder.provenance()}));
    folder.write(kDiagnosedIrregularity, irregularity_text(result.diagnosed_numbers));
    folder.write("diagnosed.toml", diagnosed_case_text(result));
}

}  // namespace railpem::app

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/output_folder.hpp"
#include "app/schema/recording_schema.hpp"
#include "app/verbs/inspection_beliefs.hpp"
#include "app/verbs/verbs.hpp"
#include "recordings/inspection/inspect.hpp"
#include "recordings/inspection/inspection_writers.hpp"

namespace railpem::app {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

struct InspectRequest {
    std::vector<std::string> recordings;
    std::vector<std::string> options;
    std::string case_path, html, folder;
    bool json = false, force = false;
};

/// All descriptions, before any data are opened. With --out files are called after them, so the names must differ.
std::vector<RecordingFile> read_recordings(const InspectRequest& request) {
    std::vector<RecordingFile> files;
    std::map<std::string, std::string> taken;
    for (const std::string& path : request.recordings) {
        files.push_back(read_recording(path));
        const auto [earlier, is_new] = taken.emplace(files.back().name, path);
        if (!is_new && !request.folder.empty())
            throw InputError(
                fmt::format("{}: its page would be called {}.inspection.html, like that of {}\nallowed: recordings of "
                            "different names",
                            path, files.back().name, earlier->second));
    }
    return files;
}

void check_outputs(const InspectRequest& request) {
    if (!request.html.empty() && request.recordings.size() > 1)
        throw InputError(
            fmt::format("--html {}: one page cannot hold {} recordings\nallowed: one recording, or --out DIR",
                        request.html, request.recordings.size()));
    std::error_code ignored;
    if (!request.html.empty() && fs::is_directory(request.html, ignored))
        throw InputError(fmt::format("--html {}: is a folder\nallowed: a file, or --out DIR", request.html));
    if (!request.html.empty() && fs::exists(request.html, ignored) && !fs::is_regular_file(request.html, ignored))
        throw InputError(fmt::format("--html {}: is a device or a pipe\nallowed: a file, or --out DIR", request.html));
    if (!request.options.empty() && request.case_path.empty())
        throw InputError("--set: there is no case to set it in\nallowed: with --case CASE");
}

std::vector<recordings::InspectionReport> inspect_all(const InspectRequest& request,
                                                      const std::vector<RecordingFile>& files) {
    std::optional<CaseFile> believed;
    if (!request.case_path.empty()) believed = read_case(request.case_path, request.options);
    std::vector<recordings::InspectionReport> reports;
    for (const RecordingFile& file : files) {
        const recordings::InspectionContext context =
            believed ? inspection_beliefs(*believed, file) : recordings::InspectionContext{};
        reports.push_back(
            reading_data(file, [&] { return recordings::inspect_file(file.description, file.base, context); }));
    }
    return reports;
}

void print_reports(const InspectRequest& request, const std::vector<recordings::InspectionReport>& reports) {
    if (!request.json) {
        for (std::size_t i = 0; i < reports.size(); ++i)
            std::fputs(((i > 0 ? "\n" : "") + recordings::to_text(reports[i])).c_str(), stdout);
        return;
    }
    Json all = Json::array();
    for (const recordings::InspectionReport& report : reports) all.push_back(recordings::to_json(report));
    std::fputs(
        ((all.size() == 1 ? all.front() : all).dump(2, ' ', false, Json::error_handler_t::replace) + "\n").c_str(),
        stdout);
}

/// 3 where a recording cannot be trusted as it is, so that a script need not read the report.
int status_of(const std::vector<recordings::InspectionReport>& reports) {
    constexpr int kErrorsInData = 3;
    for (const recordings::InspectionReport& report : reports)
        for (const recordings::Fault& fault : report.faults)
            if (fault.severity == recordings::Severity::error) return kErrorsInData;
    return 0;
}

int inspect(const InspectRequest& request) {
    check_outputs(request);
    const std::vector<RecordingFile> files = read_recordings(request);
    std::optional<OutputFolder> folder, page;
    const Writing writing = results_of_run(request.force);
    if (!request.folder.empty()) folder.emplace(request.folder, "--out", writing);
    if (!request.html.empty()) page.emplace(fs::path(request.html).parent_path(), "--html", writing);
    if (page) page->claim(fs::path(request.html).filename().string());
    for (const RecordingFile& file : files)
        for (const char* ending : {".inspection.html", ".inspection.json"})
            if (folder) folder->claim(file.name + ending);
    const std::vector<recordings::InspectionReport> reports = inspect_all(request, files);
    for (std::size_t i = 0; i < reports.size() && folder; ++i) {
        folder->write(files[i].name + ".inspection.html", recordings::to_html(reports[i]));
        folder->write(files[i].name + ".inspection.json",
                      recordings::to_json(reports[i]).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    }
    if (page) page->write(fs::path(request.html).filename().string(), recordings::to_html(reports.front()));
    if (folder) folder->commit();
    if (page) page->commit();
    print_reports(request, reports);
    return status_of(reports);
}

}  // namespace

void add_inspect(CLI::App& program, Run& run) {
    const auto request = std::make_shared<InspectRequest>();
    CLI::App* verb =
        program.add_subcommand("inspect", "what recordings hold, and whether they can be trusted: a screen of text");
    verb->footer(
        "Exit status 3: errors were found in the data; the report is printed all the same.\n"
        "Examples:\n"
        "  railpem inspect run1 --html run1.html\n"
        "  railpem inspect run1 --case case.toml");
    verb->add_option("RECORDING", request->recordings, "recordings: folders with a recording.toml, or descriptions")
        ->required();
    verb->add_flag("--json", request->json,
                   "print everything as JSON instead; a list when there are several recordings");
    verb->add_option("--html", request->html, "also a page with spectra, coherence and spectrogram")->type_name("FILE");
    verb->add_option("--out", request->folder, "also DIR/<recording>.inspection.html and .json for every recording")
        ->type_name("DIR");
    verb->add_option(
            "--case", request->case_path,
            "case file that is believed: units, levels, wheelbase and named frequencies are checked against it")
        ->type_name("CASE");
    verb->add_option("--set", request->options, "override a key of the case: key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->add_flag("--force", request->force, kForceSays);
    verb->callback([request, &run] { run = [request] { return inspect(*request); }; });
}

}  // namespace railpem::app

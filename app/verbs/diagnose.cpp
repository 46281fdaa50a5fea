#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/interrupt_guard.hpp"
#include "app/plausibility/implausible_case.hpp"
#include "app/progress_bar.hpp"
#include "app/verbs/run_diagnosis.hpp"
#include "app/verbs/verbs.hpp"

namespace railpem::app {

namespace {

struct DiagnoseRequest {
    DiagnosisRequest diagnosis;
    std::string folder;
    bool strict = false, force = false;
};

/// A case was fitted at least once: there are numbers to write.
bool is_known(const diagnosis::Diagnosis& result) {
    return result.diagnosed_numbers.vehicle.body_mass_kg > 0.0;
}

bool holds_results(const OutputFolder& folder) {
    std::error_code ignored;
    return std::filesystem::exists(folder.path() / "diagnosis.json", ignored);
}

std::string why_not_kept(const OutputFolder& folder) {
    return holds_results(folder) ? "the earlier results in " + folder.path().string() + " stay"
                                 : "the interruption came before the first fit";
}

/// Writes the result. One that was interrupted stands back where another is there already, and where nothing is known.
bool keep(OutputFolder& folder, const diagnosis::Diagnosis& result, const DiagnosisRequest& request) {
    if (result.interrupted && (!is_known(result) || holds_results(folder))) return false;
    write_diagnosis(folder, result, request);
    folder.commit();
    return true;
}

int diagnose(DiagnoseRequest request) {
    const CaseFile file = read_case(request.diagnosis.case_path, request.diagnosis.set);
    request.diagnosis.doubts = plausibility_warnings(file, case_figures(file));
    say_or_refuse(request.diagnosis.doubts, request.strict);
    std::optional<OutputFolder> folder;
    std::optional<InterruptGuard> guard;
    ProgressBar bar(file.name);
    const DiagnosisObserver observer{
        .progress = [&](double share) { bar.show(static_cast<std::size_t>(1000.0 * share), 1000); },
        .interrupted = InterruptGuard::asked};
    const diagnosis::Diagnosis result = run_diagnosis(file, request.diagnosis, observer, [&] {
        folder.emplace(request.folder, "--out", results_of_run(request.force));
        for (const char* name : kDiagnosisFiles) folder->claim(name);
        guard.emplace();
    });
    const bool kept = keep(*folder, result, request.diagnosis);
    for (const diagnosis::UsedRecording& recording : result.recordings)
        for (const std::string& fault : recording.faults)
            fmt::print(stderr, "{}: warning: {}\n", recording.name, fault);
    fmt::print("{}{}\n{}\n{}\n", diagnosis::verdict_name(result.verdict), result.interrupted ? " (interrupted)" : "",
               result.statement,
               kept ? (folder->path() / "report.html").string() : "Nothing was written: " + why_not_kept(*folder));
    return result.interrupted ? InterruptGuard::kInterrupted : 0;
}

}  // namespace

void add_diagnose(CLI::App& program, Run& run) {
    const auto request = std::make_shared<DiagnoseRequest>();
    CLI::App* verb = program.add_subcommand("diagnose",
                                            "what a believed case left out, told from recordings: DIR/diagnosis.json, "
                                            "DIR/report.html, DIR/diagnosed.toml and spectra");
    verb->footer(
        "Example:\n"
        "  railpem diagnose case.toml run_15 run_22 run_33 --out out");
    verb->add_option("CASE", request->diagnosis.case_path, "the case that was believed")->required();
    verb->add_option("RECORDING", request->diagnosis.recordings,
                     "recordings of the same vehicle and track, several speeds or loads together")
        ->required();
    verb->add_option("--out", request->folder, "folder for the results")->required()->type_name("DIR");
    verb->add_option("--window", request->diagnosis.window_s, "length of a segment in s; 4 without it")
        ->check(CLI::Range(0.25, 60.0))
        ->type_name("S");
    verb->add_option("--held-out", request->diagnosis.held_out,
                     "share of the end of every record that no fit sees; 0.25 without it")
        ->check(CLI::Range(0.1, 0.5))
        ->type_name("SHARE");
    verb->add_option("--most-effects", request->diagnosis.most_effects, "most effects named together; 3 without it")
        ->check(CLI::Range(1, 4))
        ->type_name("N");
    verb->add_option("--effort", request->diagnosis.effort_s,
                     "s of one core as the program counts them, for three recordings of a minute, after which nothing "
                     "further is looked for; 75 without it. More may name what takes long to find")
        ->check(CLI::Range(10.0, 1e6))
        ->type_name("S");
    verb->add_option("--without", request->diagnosis.without,
                     "an effect that the catalogue shall not have: what would be said if nobody knew of it")
        ->type_name("EFFECT")
        ->allow_extra_args(false);
    verb->add_flag("--strict", request->strict, "refuse a case with values that are hardly believed");
    verb->add_option("--threads", request->diagnosis.threads, "threads; all without it")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    verb->add_option("--set", request->diagnosis.set, "override a key of the case: key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->add_flag("--force", request->force, kForceSays);
    verb->callback([request, &run] { run = [request] { return diagnose(*request); }; });
}

}  // namespace railpem::app

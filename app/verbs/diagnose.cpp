#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "app/interrupt_guard.hpp"
#include "app/progress_bar.hpp"
#include "app/verbs/run_diagnosis.hpp"
#include "app/verbs/verbs.hpp"

namespace railpem::app {

namespace {

struct DiagnoseRequest {
    DiagnosisRequest diagnosis;
    std::string folder;
};

int diagnose(const DiagnoseRequest& request) {
    const CaseFile file = read_case(request.diagnosis.case_path, request.diagnosis.set);
    std::optional<OutputFolder> folder;
    std::optional<InterruptGuard> guard;
    ProgressBar bar(file.name);
    const DiagnosisObserver observer{
        .progress = [&](double share) { bar.show(static_cast<std::size_t>(1000.0 * share), 1000); },
        .interrupted = InterruptGuard::asked};
    const diagnosis::Diagnosis result = run_diagnosis(file, request.diagnosis, observer, [&] {
        folder.emplace(request.folder);
        guard.emplace();
    });
    write_diagnosis(*folder, result, request.diagnosis);
    folder->commit();
    for (const diagnosis::UsedRecording& recording : result.recordings)
        for (const std::string& fault : recording.faults)
            fmt::print(stderr, "{}: warning: {}\n", recording.name, fault);
    fmt::print("{}{}\n{}\n{}\n", diagnosis::verdict_name(result.verdict), result.interrupted ? " (interrupted)" : "",
               result.statement, (folder->path() / "report.html").string());
    return 0;
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
    verb->add_option("--threads", request->diagnosis.threads, "threads; all without it")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    verb->add_option("--set", request->diagnosis.set, "override a key of the case: key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->callback([request, &run] { run = [request] { return diagnose(*request); }; });
}

}  // namespace railpem::app

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "app/output_folder.hpp"
#include "app/plausibility/implausible_case.hpp"
#include "app/schema/case_file.hpp"
#include "app/tables/response_summary.hpp"
#include "app/tables/response_tables.hpp"
#include "app/verbs/solve_speeds.hpp"
#include "app/verbs/verbs.hpp"

namespace railpem::app {

namespace {

struct SolveRequest {
    std::vector<std::string> cases;
    std::vector<std::string> options;
    std::string folder;
    int threads = 0;
    bool bands = false, strict = false, force = false;
};

/// All cases, before anything is computed or written. Outputs are called after the files, so the names must differ.
std::vector<CaseFile> read_cases(const SolveRequest& request) {
    std::vector<CaseFile> cases;
    std::map<std::string, std::string> taken;
    for (const std::string& path : request.cases) {
        cases.push_back(read_case(path, request.options));
        const auto [earlier, is_new] = taken.emplace(cases.back().name, path);
        if (!is_new)
            throw InputError(fmt::format(
                "{}: its results would be called {}.psd.csv, like those of {}\nallowed: case files of different names",
                path, cases.back().name, earlier->second));
    }
    return cases;
}

/// What the summary says, too, where nobody looks into it.
void say_warnings(const CaseFile& file, const ResponseSpectra& speed) {
    for (const std::string& warning : pem::warnings_beside_validity(file.parameters, speed.warnings))
        fmt::print(stderr, "{}: at {:g} m/s: warning: {}\n", file.name, speed.speed_m_per_s, warning);
}

void claim_results(const OutputFolder& folder, const std::vector<CaseFile>& cases, bool bands) {
    for (const CaseFile& file : cases) {
        folder.claim(file.name + ".psd.csv");
        folder.claim(file.name + ".summary.json");
        if (bands) folder.claim(file.name + ".bands.csv");
    }
}

int solve(const SolveRequest& request) {
    const std::vector<CaseFile> cases = read_cases(request);
    OutputFolder folder(request.folder, "--out", results_of_run(request.force));
    claim_results(folder, cases, request.bands);
    for (const CaseFile& file : cases) {
        const CaseFigures figures = case_figures(file);
        std::vector<std::string> doubts = plausibility_warnings(file, figures);
        say_or_refuse(doubts, request.strict);
        const std::vector<ResponseSpectra> speeds = solve_speeds(file, request.threads);
        if (doubts.empty()) {
            doubts = response_warnings(file, speeds);
            say_or_refuse(doubts, request.strict);
        }
        folder.write(file.name + ".psd.csv", csv_text(psd_table(speeds)));
        folder.write(file.name + ".summary.json", summary_text(file, doubts, speeds));
        if (request.bands) folder.write(file.name + ".bands.csv", csv_text(bands_table(speeds)));
        for (const ResponseSpectra& speed : speeds) say_warnings(file, speed);
        fmt::print("{}{}{}\n{}{}", file.name, file.parameters.title.empty() ? "" : ": ", file.parameters.title,
                   figures_text(figures), levels_text(speeds));
    }
    folder.commit();
    return 0;
}

}  // namespace

void add_solve(CLI::App& program, Run& run) {
    const auto request = std::make_shared<SolveRequest>();
    CLI::App* verb =
        program.add_subcommand("solve", "spectra of every response: DIR/<case>.psd.csv and DIR/<case>.summary.json");
    verb->footer(
        "Examples:\n"
        "  railpem solve cases/wei2016/case1.toml cases/wei2016/case3.toml --out out\n"
        "  railpem solve case.toml --out out --set track.pads.exponent=0.15");
    verb->add_option("CASE", request->cases, "case files")->required();
    verb->add_option("--out", request->folder, "folder for the results")->required()->type_name("DIR");
    verb->add_flag("--bands", request->bands, "also DIR/<case>.bands.csv: third-octave levels");
    verb->add_option("--threads", request->threads, "threads; without it as many as the machine has")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    verb->add_flag("--strict", request->strict, "refuse a case with values that are hardly believed");
    verb->add_option("--set", request->options, "override a key of every case: key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->add_flag("--force", request->force, kForceSays);
    verb->callback([request, &run] { run = [request] { return solve(*request); }; });
}

}  // namespace railpem::app

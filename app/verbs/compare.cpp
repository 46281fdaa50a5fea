#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/output_folder.hpp"
#include "app/plausibility/implausible_case.hpp"
#include "app/schema/case_file.hpp"
#include "app/tables/level_differences.hpp"
#include "app/verbs/solve_speeds.hpp"
#include "app/verbs/verbs.hpp"

namespace railpem::app {

namespace {

struct CompareRequest {
    std::vector<std::string> cases;
    std::string folder;
    int threads = 0;
    bool force = false;
};

/// One speed each is a comparison whatever they are; lists say which speed belongs to which only when they are equal.
void check_speeds(const CompareRequest& request, const CaseFile& first, const CaseFile& second) {
    const std::vector<double>& one = first.parameters.running.speeds_m_per_s;
    const std::vector<double>& two = second.parameters.running.speeds_m_per_s;
    if (one == two || (one.size() == 1 && two.size() == 1)) return;
    throw InputError(
        fmt::format("railpem compare: running.speeds_m_per_s is [{}] in {} and [{}] in {}\nallowed: one speed in each, "
                    "or the same list in both",
                    fmt::join(one, ", "), request.cases[0], fmt::join(two, ", "), request.cases[1]));
}

int compare(const CompareRequest& request) {
    const CaseFile first = read_case(request.cases[0], {});
    const CaseFile second = read_case(request.cases[1], {});
    check_speeds(request, first, second);
    for (const CaseFile* file : {&first, &second})
        say_or_refuse(plausibility_warnings(*file, case_figures(*file)), false);
    OutputFolder folder(request.folder, "--out", results_of_run(request.force));
    std::vector<ResponseSpectra> one = solve_speeds(first, request.threads);
    std::vector<ResponseSpectra> two = solve_speeds(second, request.threads);
    for (ResponseSpectra& speed : one) speed.warnings = pem::warnings_beside_validity(first.parameters, speed.warnings);
    for (ResponseSpectra& speed : two)
        speed.warnings = pem::warnings_beside_validity(second.parameters, speed.warnings);
    std::vector<LevelDifferences> differences;
    for (std::size_t i = 0; i < one.size(); ++i) differences.push_back(level_differences(one[i], two[i]));
    for (const LevelDifferences& speed : differences)
        for (const std::string& warning : speed.warnings)
            fmt::print(stderr, "{}: at {:g} m/s: warning: {}\n", request.folder, speed.speed_1_m_per_s, warning);
    const std::string name = first.name + "-" + second.name + ".compare";
    folder.write(name + ".csv", csv_text(difference_table(differences)));
    folder.write(name + ".json", difference_summary_text(first.name, second.name, differences));
    folder.commit();
    return 0;
}

}  // namespace

void add_compare(CLI::App& program, Run& run) {
    const auto request = std::make_shared<CompareRequest>();
    CLI::App* verb = program.add_subcommand(
        "compare",
        "what changes from one case to another, third-octaves in dB, positive where the second has more: "
        "DIR/<case1>-<case2>.compare.csv and .compare.json");
    verb->footer(
        "Example:\n"
        "  railpem compare cases/wei2016/case1.toml cases/wei2016/case2.toml --out out");
    verb->add_option("CASE", request->cases, "two case files")->required()->expected(2);
    verb->add_option("--out", request->folder, "folder for the results")->required()->type_name("DIR");
    verb->add_option("--threads", request->threads, "threads; without it as many as the machine has")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    verb->add_flag("--force", request->force, kForceSays);
    verb->callback([request, &run] { run = [request] { return compare(*request); }; });
}

}  // namespace railpem::app

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/output_folder.hpp"
#include "app/schema/case_file.hpp"
#include "app/schema/read_table.hpp"
#include "app/tables/track_tables.hpp"
#include "app/verbs/verbs.hpp"

namespace railpem::app {

namespace {

struct ReceptanceRequest {
    std::string path;
    std::vector<std::string> options;
    std::string folder;
    double from_hz = 20.0;
    double to_hz = 5000.0;
    int lines = 1500;
    int threads = 0;
    bool force = false;
};

/// Frequencies whose rail still behaves like a beam: the web of a rail bends above some 5 kHz, and a slip of the
/// keyboard is told from a wish.
constexpr double kLowest = 0.01, kHighest = 20000.0;
constexpr int kMostLines = 100000;

void check_lines(const ReceptanceRequest& request) {
    if (request.from_hz < request.to_hz) return;
    throw InputError(fmt::format(
        "railpem receptance: --from {:g} --to {:g}: no frequency between them\nallowed: --from less than --to",
        request.from_hz, request.to_hz));
}

pem::TrackResponse solve_track(const CaseFile& file, const ReceptanceRequest& request) {
    const std::vector<double> lines = pem::geometric_lines(request.from_hz, request.to_hz, request.lines);
    try {
        return pem::track_response(file.parameters, lines, true, request.threads);
    } catch (const parameters::ParameterError& error) {
        throw refused(file.document, error);
    }
}

int receptance(const ReceptanceRequest& request) {
    check_lines(request);
    const CaseFile file = read_case(request.path, request.options);
    OutputFolder folder(request.folder, "--out", results_of_run(request.force));
    const pem::TrackResponse response = solve_track(file, request);
    folder.write(file.name + ".receptance.csv", csv_text(receptance_table(response)));
    folder.write(file.name + ".decay.csv", csv_text(decay_table(response, file.parameters.track.spacing_m)));
    folder.commit();
    if (!file.parameters.track.failed_fasteners.empty())
        fmt::print(stderr,
                   "{}: every support is taken as intact; failed fasteners are left out of receptance and decay rate\n",
                   file.name);
    return 0;
}

}  // namespace

void add_receptance(CLI::App& program, Run& run) {
    const auto request = std::make_shared<ReceptanceRequest>();
    CLI::App* verb = program.add_subcommand(
        "receptance", "the track without a vehicle, at rest: DIR/<case>.receptance.csv and DIR/<case>.decay.csv");
    verb->footer(
        "Example:\n"
        "  railpem receptance cases/wei2016/case1.toml --out out");
    verb->add_option("CASE", request->path, "case file")->required();
    verb->add_option("--out", request->folder, "folder for the results")->required()->type_name("DIR");
    verb->add_option("--from", request->from_hz, "first frequency, Hz (20)")
        ->check(CLI::Range(kLowest, kHighest))
        ->type_name("HZ");
    verb->add_option("--to", request->to_hz, "last frequency, Hz (5000)")
        ->check(CLI::Range(kLowest, kHighest))
        ->type_name("HZ");
    verb->add_option("--lines", request->lines, "number of frequencies, in equal ratios (1500)")
        ->check(CLI::Range(2, kMostLines))
        ->type_name("N");
    verb->add_option("--threads", request->threads, "threads; without it as many as the machine has")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    verb->add_option("--set", request->options, "override a key of the case: key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->add_flag("--force", request->force, kForceSays);
    verb->callback([request, &run] { run = [request] { return receptance(*request); }; });
}

}  // namespace railpem::app

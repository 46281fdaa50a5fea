#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>

#include "app/output_folder.hpp"
#include "app/plausibility/implausible_case.hpp"
#include "app/program_version.hpp"
#include "app/progress_bar.hpp"
#include "app/schema/case_file.hpp"
#include "app/tables/sweep_progress_file.hpp"
#include "app/tables/sweep_table.hpp"
#include "app/tables/sweep_warnings.hpp"
#include "app/verbs/verbs.hpp"
#include "ranks/join_crew.hpp"

namespace railpem::app {

namespace {

constexpr double kLargestCsv = 100e6;  ///< bytes; beyond it the automatic format is HDF5

struct SweepRequest {
    std::string sweep;
    std::vector<std::string> options;
    std::string folder;
    std::string format;
    int threads = 0;
    bool force = false;
};

/// The text that tells two sweeps apart: the case with its overrides, the design, what is kept, the program.
std::string identity(const SweepFile& sweep) {
    std::string text = program_version_with_commit() + "\n" + write_case(sweep.plan.base);
    text += fmt::format("{} {} {}\n", static_cast<int>(sweep.plan.design), sweep.plan.samples, sweep.plan.seed);
    for (const pem::SweepAxis& axis : sweep.plan.axes) {
        text += fmt::format("{} {} {} {}", axis.key, axis.low, axis.high, axis.logarithmic);
        for (const double value : axis.values) text += fmt::format(" {}", value);
        text += '\n';
    }
    for (const pem::SweepQuantity& quantity : sweep.plan.quantities)
        text += fmt::format("{} {}\n", quantity.response, static_cast<int>(quantity.kind));
    return text;
}

bool as_hdf5(const SweepRequest& request, const SweepFile& sweep) {
    if (!request.format.empty()) return request.format == "hdf5";
    if (sweep.description.format == TableFormat::automatic) return sweep_csv_bytes(sweep.plan) > kLargestCsv;
    return sweep.description.format == TableFormat::hdf5;
}

/// Results of the cases that this process is given.
void run_cases(const SweepRequest& request, const SweepFile& file, ranks::Crew& crew, SweepProgressFile& results,
               SweepWarnings& warnings) {
    const std::size_t cases = pem::sweep_size(file.plan);
    const std::unique_ptr<ranks::Dispenser> dispenser = crew.dispense(cases);
    ProgressBar bar(file.name);
    std::atomic<std::size_t> done = results.finished_at_start();
    std::mutex drawing;
    const auto keep = [&](std::size_t index, const std::vector<double>& values) {
        results.write(index, values);
        const std::size_t now = ++done;
        // The first process knows what the others have been given; it draws the bar of all.
        if (const std::unique_lock lock(drawing, std::try_to_lock); lock && crew.rank() == 0)
            bar.show(crew.size() > 1 ? dispenser->given() : now, cases);
    };
    pem::run_sweep(file.plan, request.threads,
                   {.finished = [&](std::size_t index) { return results.finished(index); },
                    .done = keep,
                    .warned =
                        [&](std::size_t index, double speed, const std::vector<std::string>& texts) {
                            for (const std::string& text : texts) warnings.add({index, speed, text});
                        },
                    .next = [&] { return dispenser->next(); }});
}

std::string table_name(const SweepRequest& request, const SweepFile& file) {
    return file.name + (as_hdf5(request, file) ? ".h5" : ".csv");
}

void write_sweep_table(const SweepRequest& request, const SweepFile& file, const SweepProgressFile& results,
                       const std::vector<SweepWarning>& warnings) {
    OutputFolder folder(request.folder, "--out", results_of_run(request.force));
    const SweepValues read = [&](std::size_t first, std::size_t count) { return results.read(first, count); };
    folder.write_by(table_name(request, file), [&](const std::filesystem::path& path) {
        if (as_hdf5(request, file))
            write_sweep_hdf5(path, file.plan, read, provenance_line(*folder.provenance()));
        else
            write_sweep_csv(path, file.plan, read, stamped(".csv", "", *folder.provenance()));
    });
    const std::string warned = file.name + ".warnings.csv";
    std::error_code ignored;
    if (warnings.empty())
        std::filesystem::remove(folder.path() / warned, ignored);  // of the run before
    else
        folder.write(warned, warnings_csv(warnings));
    folder.commit();
}

/// Refuses what cannot be written, or written over, before anything runs.
void check_folder(const SweepRequest& request, const SweepFile& file) {
    OutputFolder folder(request.folder, "--out", results_of_run(request.force));
    folder.claim(table_name(request, file));
    folder.claim(file.name + ".warnings.csv");
    folder.commit();
}

int sweep(const SweepRequest& request) {
    const std::unique_ptr<ranks::Crew> crew = ranks::join_crew();
    std::optional<SweepFile> file;
    std::optional<SweepProgressFile> results;
    crew->first_then_others([&] {
        file = read_sweep(request.sweep, request.options);
        check_folder(request, *file);
        if (crew->rank() == 0) say_or_refuse(sweep_warnings(request.sweep, file->plan), false);
        results.emplace(std::filesystem::path(request.folder) / (file->name + ".unfinished"), identity(*file),
                        pem::sweep_size(file->plan), pem::sweep_rows(file->plan).size(), crew->rank());
    });
    SweepWarnings warnings(std::filesystem::path(request.folder) / (file->name + ".unfinished"), crew->rank());
    run_cases(request, *file, *crew, *results, warnings);
    results->flush();
    crew->meet();
    if (crew->rank() != 0) return 0;
    results->gather();
    const std::vector<SweepWarning> found = warnings.gather();
    write_sweep_table(request, *file, *results, found);
    results->remove();
    warnings.remove();
    fmt::print(stderr, "{}", warnings_text(found, pem::sweep_size(file->plan)));
    return 0;
}

}  // namespace

void add_sweep(CLI::App& program, Run& run) {
    const auto request = std::make_shared<SweepRequest>();
    CLI::App* verb = program.add_subcommand(
        "sweep", "many cases: DIR/<sweep>.csv, one long table; goes on where it was interrupted");
    verb->footer(
        "Example:\n"
        "  railpem sweep cases/wei2016/pads.sweep.toml --out out");
    verb->add_option("SWEEP", request->sweep, "sweep file")->required();
    verb->add_option("--out", request->folder, "folder for the results")->required()->type_name("DIR");
    verb->add_option("--format", request->format,
                     "csv or hdf5; without it as the sweep file says, else HDF5 beyond 100 MB")
        ->check(CLI::IsMember({"csv", "hdf5"}));
    verb->add_option("--threads", request->threads, "threads; without it as many as the machine has")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    verb->add_option("--set", request->options, "override a key of the case: key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->add_flag("--force", request->force, kForceSays);
    verb->callback([request, &run] { run = [request] { return sweep(*request); }; });
}

}  // namespace railpem::app

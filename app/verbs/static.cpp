#include <CLI/CLI.hpp>
#include <memory>

#include "app/output_folder.hpp"
#include "app/schema/case_file.hpp"
#include "app/schema/read_table.hpp"
#include "app/tables/response_tables.hpp"
#include "app/verbs/verbs.hpp"
#include "pem/rail/case_equilibrium.hpp"

namespace railpem::app {

namespace {

struct StaticRequest {
    std::string path;
    std::vector<std::string> options;
    std::string folder;
    bool force = false;
};

track::StaticEquilibrium equilibrium_of(const CaseFile& file) {
    try {
        return pem::case_equilibrium(file.parameters);
    } catch (const parameters::ParameterError& error) {
        throw refused(file.document, error);
    }
}

int solve_static(const StaticRequest& request) {
    const CaseFile file = read_case(request.path, request.options);
    OutputFolder folder(request.folder, "--out", results_of_run(request.force));
    const track::StaticEquilibrium equilibrium = equilibrium_of(file);
    folder.write(file.name + ".static.csv", csv_text(static_table(equilibrium)));
    folder.commit();
    for (const std::string& warning : equilibrium.warnings)
        std::fputs((file.name + ": " + warning + "\n").c_str(), stderr);
    return 0;
}

}  // namespace

void add_static(CLI::App& program, Run& run) {
    const auto request = std::make_shared<StaticRequest>();
    CLI::App* verb = program.add_subcommand(
        "static", "compression and stiffness of every pad under the standing vehicle: DIR/<case>.static.csv");
    verb->footer(
        "Example:\n"
        "  railpem static cases/wei2016/case3.toml --out out");
    verb->add_option("CASE", request->path, "case file")->required();
    verb->add_option("--out", request->folder, "folder for the results")->required()->type_name("DIR");
    verb->add_option("--set", request->options, "override a key of the case: key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->add_flag("--force", request->force, kForceSays);
    verb->callback([request, &run] { run = [request] { return solve_static(*request); }; });
}

}  // namespace railpem::app

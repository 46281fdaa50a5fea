#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "app/diagnosis_inputs.hpp"
#include "app/verbs.hpp"
#include "diagnosis/fit.hpp"

namespace railpem::app {
namespace {
struct DiagnoseRequest {
    std::string case_path, folder;
    std::vector<std::string> recordings, set;
    double window_s = 4.0;
};

int diagnose(const DiagnoseRequest& request) {
    const CaseFile file = read_case(request.case_path, request.set);
    const diagnosis::BelievedCase believed = believed_case(file);
    const auto t0 = std::chrono::steady_clock::now();
    const auto now = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count(); };
    std::vector<diagnosis::Observation> observations;
    for (const std::string& path : request.recordings) {
        const RecordingFile description = read_recording(path);
        observations.push_back(diagnosis::observe(load_recording(description), description.name, believed.numbers, {.window_s = request.window_s}));
    }
    fmt::print("read {:.2f} s, averages {:.1f}\n", now(), observations[0].fitted.averages);
    diagnosis::LikelihoodContext context{.believed = &believed, .observations = &observations};
    const diagnosis::Trial trial = diagnosis::believed_trial(believed, observations);
    auto unknowns = diagnosis::nuisance_unknowns(believed, observations);
    fmt::print("{} unknowns\n", unknowns.size());
    const auto p0 = now();
    diagnosis::predict(trial, context);
    fmt::print("predict {:.4f}\n", now() - p0);
    const diagnosis::Fit fit = diagnosis::fit(trial, unknowns, diagnosis::means(unknowns), context);
    fmt::print("fit {:.2f} s, {} iterations, converged {}, logL {:.1f} evidence {:.1f}\n", now(), fit.iterations, fit.converged, fit.log_likelihood, fit.log_evidence);
    for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
        fmt::print("{:50s} {:9.5f} +- {:.5f}  ({:.2f} sd of belief)\n", fit.unknowns[i].name, fit.values[i], fit.deviation(i), (fit.values[i] - fit.unknowns[i].mean) / fit.unknowns[i].deviation);
    std::size_t bins = 0;
    for (const auto& o : observations) bins += o.bins();
    fmt::print("logL per bin {:.3f} of {} bins\n", fit.log_likelihood / static_cast<double>(bins), bins);
    return 0;
}
}  // namespace

void add_diagnose(CLI::App& program, Run& run) {
    const auto request = std::make_shared<DiagnoseRequest>();
    CLI::App* verb = program.add_subcommand("diagnose", "what a believed case left out, told from recordings");
    verb->add_option("CASE", request->case_path, "case file")->required();
    verb->add_option("RECORDING", request->recordings, "recordings")->required();
    verb->add_option("--out", request->folder, "folder");
    verb->add_option("--window", request->window_s, "segment");
    verb->add_option("--set", request->set, "override a key of the case: key=value")->type_name("KEY=VALUE")->allow_extra_args(false);
    verb->callback([request, &run] { run = [request] { return diagnose(*request); }; });
}
}  // namespace railpem::app

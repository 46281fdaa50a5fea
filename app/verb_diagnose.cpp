#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "app/diagnosis_inputs.hpp"
#include "app/verbs.hpp"
#include "diagnosis/name.hpp"

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
    diagnosis::NamingOptions options;
    options.progress = [&, last = std::string()](const std::string& what, double) mutable {
        if (what != last) fmt::print("{:7.2f} s {}\n", now(), what);
        last = what;
        std::fflush(stdout);
    };
    const diagnosis::NamingResult result = diagnosis::name_physics(believed, context, options);
    fmt::print("{:.2f} s, {} candidates\n", now(), result.candidates.size());
    for (std::size_t i = 0; i < 14; ++i) {
        const auto& p = result.first_promises[i];
        const auto& c = result.candidates[p.candidate];
        std::string text;
        for (const auto& [k, v] : c.instance.values) text += fmt::format(" {}={:g}", k, v);
        fmt::print("promise {:9.1f} strength {:9.2g}  {}{}\n", p.gain, p.strength, diagnosis::label_of(c.instance), text);
    }
    const auto show = [&](const diagnosis::FittedSet& set) {
        std::string text;
        for (std::size_t i = set.fit.trial.effects.size() - set.effects.size(); i < set.fit.trial.effects.size(); ++i) {
            text += diagnosis::label_of(set.fit.trial.effects[i]);
            for (const auto& [k, v] : set.fit.trial.effects[i].values) text += fmt::format(" {}={:.4g}", k, v);
            text += "; ";
        }
        for (const auto& key : set.released) text += key + "; ";
        fmt::print("score {:10.1f} logL {:10.1f} held {:9.1f} it {:2d} conv {} {}\n", set.score(), set.fit.log_likelihood, set.held_out, set.fit.iterations, set.fit.converged, text);
    };
    show(result.retuned);
    for (const auto& set : result.sets) show(set);
    const diagnosis::Fit& fit = result.sets.empty() ? result.retuned.fit : result.sets[0].fit;
    for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
        if (fit.unknowns[i].kind == diagnosis::UnknownKind::number || fit.unknowns[i].kind == diagnosis::UnknownKind::effect || std::abs(fit.values[i] - fit.unknowns[i].mean) > 2 * fit.unknowns[i].deviation)
        fmt::print("{:50s} {:9.5f} +- {:.5f}  ({:.2f} sd of belief)\n", fit.unknowns[i].name, fit.values[i], fit.deviation(i), (fit.values[i] - fit.unknowns[i].mean) / fit.unknowns[i].deviation);
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

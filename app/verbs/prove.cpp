#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>

#include "app/fingerprint.hpp"
#include "app/interrupt_guard.hpp"
#include "app/output_folder.hpp"
#include "app/page/page_parts.hpp"
#include "app/progress_bar.hpp"
#include "app/prove/proof.hpp"
#include "app/prove/score_proof.hpp"
#include "app/prove/score_tables.hpp"
#include "app/schema/believed_case.hpp"
#include "app/schema/world_option.hpp"
#include "app/verbs/verbs.hpp"
#include "ranks/join_crew.hpp"

namespace railpem::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kQuickTrials = 8;

struct ProveRequest {
    std::string case_path, folder, shard, world = "good";
    std::vector<std::string> set;
    std::size_t trials = 0;
    std::uint64_t seed = 1;
    double seconds = 60.0;
    int threads = 0;
    bool quick = false, keep = false, force = false;
};

ProofSettings settings_of(const ProveRequest& request) {
    ProofSettings settings{.trials = request.trials, .keep = request.keep};
    settings.draw.seed = request.seed;
    settings.draw.seconds = request.seconds;
    settings.draw.world = read_world_option(request.world);
    if (request.quick) settings.draw.most_records = 1;
    if (settings.trials == 0) settings.trials = kQuickTrials;
    settings.options.diagnosis.threads = request.threads;
    settings.options.diagnosis.interrupted = InterruptGuard::asked;
    if (!request.shard.empty()) settings.shard = read_shard(request.shard);
    return settings;
}

/// Tells builds apart: a proof whose trials come from several says so.
std::string program_fingerprint() {
    std::ifstream own("/proc/self/exe", std::ios::binary);
    std::ostringstream bytes;
    bytes << own.rdbuf();
    return fingerprint_text(bytes.str());
}

/// A bar on a terminal, a line per trial elsewhere. What was hidden is not told before all is over.
class Reporter {
  public:
    /// `processes`: how many share the trials, all of them about as fast.
    Reporter(std::string label, int processes)
        : bar_(std::move(label)), lines_(::isatty(STDERR_FILENO) != 1), processes_(processes) {}

    void within(std::size_t done, std::size_t all, double share) {
        bar_.show(static_cast<std::size_t>(kParts * (static_cast<double>(done) + share)), kParts * all);
    }

    void finished(std::size_t done, std::size_t all, const TrialResult& last) {
        within(done, all, 0.0);
        if (!lines_) return;
        const double each = std::chrono::duration<double>(Clock::now() - begin_).count() / static_cast<double>(done);
        const long remaining =
            std::lround(each * std::max(0.0, static_cast<double>(all) / processes_ - static_cast<double>(done)));
        fmt::print("trial {:4}  {:<16} {:5.0f} s  remaining {}:{:02}:{:02}\n", last.trial,
                   last.failure.empty() ? last.verdict : "failed", last.seconds_simulated + last.seconds_diagnosed,
                   remaining / 3600, remaining / 60 % 60, remaining % 60);
        std::fflush(stdout);
    }

  private:
    static constexpr std::size_t kParts = 1000;
    ProgressBar bar_;
    bool lines_;
    int processes_;
    Clock::time_point begin_ = Clock::now();
};

void run_open_trials(const std::vector<TrialTruth>& truths, const diagnosis::BelievedCase& believed,
                     const ProofSettings& settings, const ProofFolder& folder, ranks::Crew& crew) {
    const InterruptGuard guard;
    Reporter reporter("proof", crew.size());
    std::size_t done = 0, all = 0;
    for (const TrialTruth& truth : truths) all += settings.shard.holds(truth.trial) && !folder.finished(truth.trial);
    TrialOptions options = settings.options;
    options.diagnosis.progress = [&](const std::string&, double share) { reporter.within(done, all, share); };
    const std::string program = program_fingerprint();
    const auto run = [&](const TrialTruth& truth, const std::filesystem::path& keep) {
        TrialResult result = run_trial(believed, truth, options, keep);
        result.program = program;
        return result;
    };
    const auto progress = [&](std::size_t finished, std::size_t open, const TrialResult& last) {
        done = finished;
        reporter.finished(finished, open, last);
    };
    const std::unique_ptr<ranks::Dispenser> dispenser = crew.dispense(truths.size());
    run_trials(truths, settings, folder, run, progress, InterruptGuard::asked, [&] { return dispenser->next(); });
}

void write_score(const std::vector<TrialTruth>& truths, const ProofFolder& folder, const std::string& settings,
                 bool force) {
    std::vector<TrialTruth> finished;
    std::vector<TrialResult> results;
    for (const TrialTruth& truth : truths)
        if (std::optional<TrialResult> result = folder.finished(truth.trial)) {
            finished.push_back(truth);
            results.push_back(std::move(*result));
        }
    const std::vector<ScoredTrial> trials = judge_all(finished, results);
    const ProofScore score = score_of(trials);
    OutputFolder output(folder.path(), "--out", results_of_run(force));
    output.write("trials.csv", trials_csv(trials));
    output.write("score.json", score_json(score, trials, settings, truths.size()));
    output.commit();
    fmt::print("{} of {} trials finished\n{}{}\n", finished.size(), truths.size(), score_lines(score),
               (folder.path() / "score.json").string());
}

int prove(const ProveRequest& request) {
    const ProofSettings settings = settings_of(request);
    const CaseFile file = request.case_path.empty()
                              ? parse_case("wei2016/case1", std::string(proved_case()), request.set)
                              : read_case(request.case_path, request.set);
    const diagnosis::BelievedCase believed = believed_case(file);
    const std::string text = settings_text(file, settings);
    const std::vector<TrialTruth> truths = draw_trials(file, believed, settings);
    const std::unique_ptr<ranks::Crew> crew = ranks::join_crew();
    std::optional<ProofFolder> folder;
    crew->first_then_others([&] {
        folder.emplace(request.folder, text);
        folder->seal(truths);
    });
    run_open_trials(truths, believed, settings, *folder, *crew);
    crew->meet();
    if (settings.shard.count == 1 && crew->rank() == 0) write_score(truths, *folder, text, request.force);
    return 0;
}

}  // namespace

void add_prove(CLI::App& program, Run& run) {
    const auto request = std::make_shared<ProveRequest>();
    CLI::App* verb = program.add_subcommand("prove",
                                            "trials in which effects are hidden and the diagnosis has to find them: "
                                            "DIR/score.json, DIR/trials.csv; goes on where it was interrupted");
    verb->footer(
        "Examples:\n"
        "  railpem prove --quick --out out\n"
        "  railpem prove --trials 300 --seed 1 --shard 1/2 --out out    (and 2/2 on another machine)");
    verb->add_option("--trials", request->trials, "number of trials; 8 without it")
        ->check(CLI::Range(std::size_t{1}, std::size_t{100000}))
        ->type_name("N");
    verb->add_option("--seed", request->seed, "draws all trials; 1 without it")
        ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 62))
        ->type_name("S");
    verb->add_option("--out", request->folder, "folder for truths, trials and score")->required()->type_name("DIR");
    verb->add_option("--case", request->case_path, "the believed case; case 1 of Wei et al. 2016 without it")
        ->type_name("FILE");
    verb->add_option("--set", request->set, "override a key of the case: key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->add_option("--seconds", request->seconds, "length of every record in s; 60 without it")
        ->check(CLI::Range(20.0, 3600.0))
        ->type_name("T");
    verb->add_option("--world", request->world,
                     "ideal, good or worn: how imperfect the recordings are, as for simulate; good without it")
        ->type_name("GRADE[:key=value,…]");
    verb->add_option("--shard", request->shard,
                     "run every n-th trial only, beginning with the i-th; a run without it afterwards adds up")
        ->type_name("I/N");
    verb->add_option("--threads", request->threads, "threads; all without it")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    verb->add_flag("--quick", request->quick, "one speed per trial");
    verb->add_flag("--keep", request->keep, "keep the recordings: DIR/trials/<trial>/record_<k>");
    verb->add_flag("--force", request->force, kForceSays);
    verb->callback([request, &run] { run = [request] { return prove(*request); }; });
}

}  // namespace railpem::app

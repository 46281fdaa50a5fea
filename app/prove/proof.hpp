#pragma once
// The proof as a whole: truths sealed first, then trial after trial, each of them kept as it ends.

#include <filesystem>
#include <functional>
#include <optional>

#include "app/prove/proof_score.hpp"
#include "app/prove/trial_draw.hpp"
#include "app/prove/trial_run.hpp"
#include "app/schema/case_file.hpp"

namespace railpem::app {

/// Every n-th trial: those whose number leaves `index` when divided by `count`.
struct Shard {
    std::size_t index = 0, count = 1;
    bool holds(std::size_t trial) const { return trial % count == index; }
};

/// Reads "i/n", 1 ≤ i ≤ n. Throws InputError.
Shard read_shard(const std::string& text);

struct ProofSettings {
    std::size_t trials = 0;
    DrawSettings draw;
    TrialOptions options;
    Shard shard;
    bool keep = false;  ///< keep the recordings
};

/// What makes two proofs the same one, as JSON: seed, mix and ranges of the draws, the believed case, version,
/// thresholds and options of the diagnosis. The number of trials is not in it: a proof may be lengthened.
std::string settings_text(const CaseFile& file, const ProofSettings& settings);

/// Runs one trial; the second argument is where its recordings are to be kept (empty: nowhere).
using TrialRunner = std::function<TrialResult(const TrialTruth&, const std::filesystem::path&)>;

/// What is told while a proof runs: trials finished in this run, and those that it will finish. `last`: the one just
/// finished.
using ProofProgress = std::function<void(std::size_t done, std::size_t all, const TrialResult& last)>;

/// DIR of a proof: proof.json (settings), truth/<trial>.json, trials/<trial>.json.
class ProofFolder {
  public:
    /// Takes the folder over, or opens one that the same settings have begun. Throws InputError when it belongs to
    /// another proof.
    ProofFolder(std::filesystem::path folder, const std::string& settings);

    /// Writes all truths that are not there. Throws InputError when one that is there differs.
    void seal(const std::vector<TrialTruth>& truths) const;

    std::optional<TrialResult> finished(std::size_t trial) const;
    void keep(const TrialTruth& truth, const TrialResult& result) const;
    std::filesystem::path recordings_of(std::size_t trial) const;
    const std::filesystem::path& path() const { return folder_; }

  private:
    std::filesystem::path folder_;
};

/// Draws all trials of the proof.
std::vector<TrialTruth> draw_trials(const CaseFile& file, const diagnosis::BelievedCase& believed,
                                    const ProofSettings& settings);

/// Runs the trials that `next` gives (places in `truths`, until it gives nothing; without it all in order) and that
/// belong to the shard and are not finished, until `interrupted`. A result that came while an end was asked for is not
/// kept: it may have been cut short.
void run_trials(const std::vector<TrialTruth>& truths, const ProofSettings& settings, const ProofFolder& folder,
                const TrialRunner& run, const ProofProgress& progress, const std::function<bool()>& interrupted,
                std::function<std::optional<std::size_t>()> next = {});

}  // namespace railpem::app

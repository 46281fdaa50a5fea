#pragma once
// The search for the set of effects that was left out.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/fitted_set.hpp"
#include "diagnosis/from_afar.hpp"
#include "diagnosis/locate.hpp"
#include "diagnosis/screen.hpp"

namespace railpem::diagnosis {

/// Thresholds of the search. Set by judgement on a few dozen marched and drawn recordings; calibrate_verdict measures
/// their false alarms.
struct NamingOptions {
    int most_effects = 3;
    /// effects that the catalogue shall not have: what would be said if nobody knew of them
    std::vector<std::string> without;
    int refits = 7;              ///< candidates refitted in the first round
    int later_refits = 3;        ///< and in each further one
    double least_promise = 7.0;  ///< nats to first order that deserve a refit
    /// nats that free corrections may promise by chance; more, and the search starts again from afar
    double residual = 12.0;
    double least_gain = 5.0;  ///< nats of log-evidence with prior that a further member must bring
    /// Effort after which nothing further is looked for, of three minutes of recordings with nine channels:
    /// effort_allowed()
    double effort_s = 75.0;
    std::function<void(const std::string&, double)> progress;  ///< what is being done, share done
    std::function<bool()> interrupted;  ///< asked between steps; true ends the search with what is known
};

struct NamingResult {
    FittedSet retuned;            ///< nothing added
    std::vector<FittedSet> sets;  ///< everything that was fitted with something added, best score first
    /// those that drop_superfluous() took out, without what their fits hold: they still say what their members explain
    std::vector<FittedSet> dropped;
    std::vector<NotTested> not_tested;
    std::vector<Promise> first_promises;
    std::vector<Candidate> candidates;
    /// what free corrections would still bring beside the best set; empty: not asked
    std::vector<LocatedEvidence> left_by_best;
    std::vector<LocatedEvidence> left_by_retuned;  ///< and beside the retuned case
    BluntCorrections blunt_corrections;            ///< free corrections of the evident places; without sets: not asked
    std::optional<FittedSet> beyond;               ///< the best single beyond its range, where that was asked
    /// of what a fit gains, what is there should gain in the unseen part: its length by that of the fitted one
    double unseen_share = 0.0;
    bool interrupted = false;
};

/// Retunes, screens, refits, adds and swaps. `context.part` should be the fitted part.
NamingResult name_physics(const BelievedCase& believed, const LikelihoodContext& context, const NamingOptions& options);

}  // namespace railpem::diagnosis

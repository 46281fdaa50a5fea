#pragma once
// What a search has fitted and found, as data.

#include <optional>
#include <vector>

#include "diagnosis/hypotheses/fitted_set.hpp"
#include "diagnosis/hypotheses/locate.hpp"
#include "diagnosis/hypotheses/screen.hpp"

namespace railpem::diagnosis {

/// Free corrections as the blunt likelihood has them, best first, and the score of the case without.
struct BluntCorrections {
    std::vector<FittedSet> sets;
    double nothing = 0.0;
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

}  // namespace railpem::diagnosis

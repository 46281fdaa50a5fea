#pragma once
// The search for the set of effects that was left out.

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/candidates.hpp"
#include "diagnosis/corrections.hpp"
#include "diagnosis/fit.hpp"
#include "diagnosis/locate.hpp"
#include "diagnosis/screen.hpp"

namespace railpem::diagnosis {

/// A supposition that was fitted: effects added, numbers released from their tolerances, or a free correction of a place.
struct FittedSet {
    std::vector<Candidate> effects;     ///< as started; the fitted values are in fit.trial.effects
    std::vector<std::string> released;  ///< keys of numbers whose belief was given up (parameter-error)
    std::vector<CorrectionPlace> anonymous;
    Fit fit;
    double log_prior = 0.0;
    double held_out = 0.0;     ///< log-likelihood of the held-out part
    double score() const { return fit.log_evidence + log_prior; }
    std::size_t members() const { return effects.size() + released.size(); }
};

/// Calibrated on nulls; see thresholds.md beside this file.
struct NamingOptions {
    int most_effects = 3;
    int refits = 7;             ///< candidates refitted in the first round
    int later_refits = 3;       ///< and in each further one
    double least_promise = 7.0; ///< nats to first order that deserve a refit
    double residual = 12.0;     ///< nats that free corrections may promise by chance; more, and the search starts again from afar
    double least_gain = 5.0;    ///< nats of log-evidence with prior that a further member must bring
    std::function<void(const std::string&, double)> progress;  ///< what is being done, share done
    std::function<bool()> interrupted;  ///< asked between steps; true ends the search with what is known
};

struct NamingResult {
    FittedSet retuned;              ///< nothing added
    std::vector<FittedSet> sets;    ///< everything that was fitted with something added, best score first
    std::vector<NotTested> not_tested;
    std::vector<Promise> first_promises;
    std::vector<Candidate> candidates;
    std::vector<LocatedEvidence> left_by_best;  ///< what free corrections would still bring beside the best set
    bool interrupted = false;
};

/// Retunes, screens, refits, adds and swaps. `context.part` should be the fitted part.
NamingResult name_physics(const BelievedCase& believed, const LikelihoodContext& context, const NamingOptions& options);

/// Fits a set from a fit that is near, with the effects at their starting strength.
FittedSet fit_set(const BelievedCase& believed, const Fit& near, std::vector<Candidate> effects, std::vector<std::string> released,
                  std::vector<CorrectionPlace> anonymous, const LikelihoodContext& context, const FitOptions& options);

/// Log-likelihood of a part at a fit's values.
double part_log_likelihood(const Fit& fit, const LikelihoodContext& context, Part part);

}  // namespace railpem::diagnosis

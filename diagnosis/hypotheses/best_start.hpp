#pragma once
// Where the fit of a candidate begins.

#include <limits>
#include <string>
#include <vector>

#include "diagnosis/hypotheses/fitted_set.hpp"
#include "diagnosis/hypotheses/worth_refitting.hpp"

namespace railpem::diagnosis {

/// A start of a candidate beside others, and how probable it is as it stands.
struct Started {
    Candidate candidate;
    Fit near;
    double log_posterior = -std::numeric_limits<double>::infinity();
};

/// The most probable start of a variant beside `members`, from where its promises lead: of each the step that was
/// promised, or the part of it that holds.
Started best_start(const BelievedCase& believed, const Fit& near, const Starts& starts,
                   const std::vector<Candidate>& candidates, const std::vector<Candidate>& members,
                   const std::vector<std::string>& released, const LikelihoodContext& context);

}  // namespace railpem::diagnosis

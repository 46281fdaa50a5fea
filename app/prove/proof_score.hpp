#pragma once
// All trials together: the figures by which the diagnosis is judged.

#include <map>
#include <string>
#include <vector>

#include "app/prove/trial_judgement.hpp"

namespace railpem::app {

/// A finished trial with its truth and its judgement.
struct ScoredTrial {
    const TrialTruth* truth = nullptr;
    const TrialResult* result = nullptr;
    Judgement judgement;
};

/// A proportion with its name and what it counts.
struct Measure {
    std::string name;
    std::string says;
    Proportion proportion;
    double goal = 0.0;     ///< of the proportion
    bool at_most = false;  ///< the goal is an upper one
    bool has_goal = false;
};

/// A bin of the calibration curve: sets of effects that the posterior gave about this probability.
struct CalibrationBin {
    double low = 0.0, high = 0.0;
    double mean_probability = 0.0;
    Proportion true_sets;
};

/// How strong an effect has to be before it is seen, from the single trials.
struct Detectability {
    std::string effect, parameter;  ///< parameter empty: there or not
    bool weak_when_large = false;
    Proportion detected, named;                            ///< something was claimed; the right set was named
    double smallest_detected = 0.0, largest_missed = 0.0;  ///< in the sense of strength; NaN where there is none
    /// strength that separates missed from detected with the fewest exceptions; NaN as above
    double threshold = 0.0;
};

/// Quantiles over trials.
struct Spread {
    double median = 0.0, ninetieth = 0.0, largest = 0.0;
    std::size_t of = 0;
};

struct ProofScore {
    std::size_t trials = 0, failed = 0;
    std::map<std::string, std::size_t> kinds;
    std::vector<Measure> measures;
    double mean_set_size = 0.0;  ///< of the sets returned, where any was; NaN of none
    /// share of the held-out misfit of the retuned case that the rightly named physics removes, pooled
    double misfit_removed = 0.0;
    double misfit_removed_median = 0.0;  ///< over trials
    std::size_t misfit_trials = 0;
    Spread seconds;                                                       ///< computing time of a diagnosis
    std::map<std::string, std::map<std::string, std::size_t>> confusion;  ///< hidden → returned → trials
    std::vector<CalibrationBin> calibration;
    std::vector<Detectability> detectability;
};

}  // namespace railpem::app

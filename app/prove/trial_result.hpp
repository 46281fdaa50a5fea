#pragma once
// What the diagnosis said about a trial: all that is kept of it.

#include <map>
#include <string>
#include <vector>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app {

/// An effect that was named, with its intervals.
struct ClaimedEffect {
    std::string effect;
    std::map<std::string, std::string> choices;  ///< which channel, wheel, stage, number
    std::string element;
    double probability = 0.0;
    std::vector<diagnosis::FittedParameter> parameters;
};

/// A set of effects among those that were returned as possible.
struct ClaimedSet {
    std::vector<ClaimedEffect> effects;
    double probability = 0.0;
};

/// A believed number after the diagnosis.
struct ClaimedNumber {
    std::string key;
    double value = 0.0, low = 0.0, high = 0.0;  ///< interval of 90 %
};

struct TrialResult {
    std::size_t trial = 0;
    std::string failure;  ///< what stopped the trial; empty: nothing did
    std::string verdict;
    std::vector<ClaimedEffect> omitted;
    std::vector<ClaimedSet> rivals;               ///< of an ambiguous verdict: all that cannot be told apart
    std::vector<diagnosis::EffectSet> posterior;  ///< one entry per set of identifiers (sorted), most probable first
    std::vector<std::pair<std::string, double>> places;  ///< element and probability, ranked
    diagnosis::FitFigures before, retuned, after, held_out_before, held_out_retuned, held_out_after;
    double hidden_by_retuning = 0.0;
    std::vector<std::string> retuned_outside;  ///< believed numbers that retuning alone drives out of their tolerances
    std::vector<ClaimedNumber> numbers;
    double bic_gain = 0.0;  ///< of the best set over the retuned case by the PSDs alone; above 0: BIC would take it
    double seconds_simulated = 0.0, seconds_diagnosed = 0.0;  ///< computing time
    std::string program;                                      ///< fingerprint of the program that ran the trial
};

/// What is kept of a diagnosis. Retuned is what retuning may do that leaves its beliefs for what they cost, whatever
/// the verdict is held against: what it conceals, and how far it goes, is the same question of every trial.
TrialResult trial_result(std::size_t trial, const diagnosis::Diagnosis& diagnosis);

/// The Bayesian information criterion from the PSDs alone: 2·Δlog L − k·ln N, channels and bins taken as independent
/// estimates with their averages, both fits as the diagnosis found them. Positive: the best set of effects is worth its
/// k parameters. A set that only gives up beliefs is to the PSDs what retuning has done already.
double bic_gain_of_psds(const diagnosis::Diagnosis& diagnosis);

/// The file of a finished trial. `label`: JSON of what was hidden, put beside the result after it was found.
std::string trial_result_text(const TrialResult& result, const std::string& label);

/// Reads such a file. Throws InputError, naming `name`.
TrialResult read_trial_result(const std::string& name, const std::string& text);

}  // namespace railpem::app

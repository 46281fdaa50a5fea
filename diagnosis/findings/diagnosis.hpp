#pragma once
// The result of a diagnosis, as data: what diagnosis.json, the tables and the report are written from.

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/effects/effect.hpp"
#include "diagnosis/effects/element.hpp"
#include "diagnosis/findings/imperfections.hpp"
#include "diagnosis/judge/channel_comparison.hpp"
#include "diagnosis/judge/probabilities.hpp"
#include "diagnosis/judge/verdict_kind.hpp"
#include "diagnosis/observations/observation.hpp"
#include "pem/case_parameters.hpp"

namespace railpem::diagnosis {

/// What one recording alone would have a parameter be.
struct RecordedValue {
    std::string recording;
    double value = 0.0;
};

/// A fitted value with its 90 % interval.
struct FittedParameter {
    std::string name;
    double value = 0.0, low = 0.0, high = 0.0;
    std::string unit;
    std::vector<RecordedValue> by_recording;  ///< where several speak of it
    double nats_against_one_value = 0.0;      ///< by which those disagree beyond what the law gets wrong
};

/// An effect that was left out.
struct NamedEffect {
    EffectInstance instance;  ///< with its fitted values
    Element element = Element::body;
    double probability = 0.0;
    std::string says;    ///< one sentence
    std::string source;  ///< literature
    std::vector<FittedParameter> parameters;
    double nats_fitted = 0.0;    ///< log-likelihood that it explains in what the fit saw
    double nats_held_out = 0.0;  ///< and in what no fit saw
};

/// Another set of effects and how it stands against the first.
struct Rival {
    std::vector<std::string> effects;
    std::vector<EffectInstance> instances;
    double probability = 0.0;
    double nats_behind = 0.0;    ///< log-evidence that it lacks
    double nats_held_out = 0.0;  ///< log-likelihood of what no fit saw, over retuning that may leave its beliefs
    std::string why_not;
    std::string would_separate;
};

/// Figures of one fit, on what it saw or not.
struct FitFigures {
    double rms_db = 0.0;                     ///< over channels and third octaves
    double log_likelihood_per_second = 0.0;  ///< relative to the saturated model: 0 is the best possible
};

/// A number of the believed case after retuning.
struct RetunedNumber {
    std::string key, unit;
    double believed = 0.0, value = 0.0, low = 0.0, high = 0.0;  ///< interval of 90 %
    double tolerance = 0.0;                                     ///< relative standard deviation of the belief
    double tolerances_away = 0.0;                               ///< signed
    bool outside = false;                                       ///< more than two tolerances away
};

/// The dynamic stiffness that the recordings infer at a place, as a factor on the retuned one.
struct InferredCurve {
    Element element = Element::pad;
    std::string unit;  ///< of the dynamic stiffness or mass
    std::vector<double> frequency_hz;
    std::vector<std::complex<double>> value;
    std::vector<double> real_low, real_high;  ///< 90 % band of the real part
    std::vector<double> imaginary_low, imaginary_high;
    /// the laws of the retuned and of the diagnosed case; may be empty
    std::vector<std::complex<double>> retuned, diagnosed;
};

/// One recording as it was used.
struct UsedRecording {
    std::string name;
    double speed_m_per_s = 0.0, speed_low = 0.0, speed_high = 0.0;  ///< as fitted, with 90 % interval
    ObservedSpeed observed_speed;
    double stated_speed_m_per_s = 0.0, payload_kg = 0.0, seconds = 0.0, held_out_seconds = 0.0;
    double low_hz = 0.0, high_hz = 0.0, window_s = 0.0, averages = 0.0;
    std::vector<std::string> channels, channels_not_used, faults;
    bool irregularity_measured = false;
};

/// How far a diagnosis was from saying something else, nats.
struct Margins {
    double score = 0.0;     ///< log-evidence with prior of the best set over the retuned case
    double held_out = 0.0;  ///< log-likelihood of the held-out part, that set over the retuned case
    double place = 0.0;     ///< most that a free correction promises beside the retuned case
};

/// Retuning that may leave its beliefs for what they cost, where the verdict is held against a retuned case that keeps
/// those which are given up.
struct FreelyRetuned {
    FitFigures fitted, held_out;
};

struct Diagnosis {
    Verdict verdict = Verdict::unexplained;
    bool interrupted = false;  ///< ended early: what is known so far
    std::string statement;
    std::vector<NamedEffect> omitted;
    std::vector<EffectSet> posterior;
    std::vector<Rival> rivals;
    std::vector<PlaceEvidence> places;  ///< ranked
    std::vector<Mismatch> mismatch;     ///< most certain first
    FitFigures before, retuned, after;
    FitFigures held_out_before, held_out_retuned, held_out_after;
    /// share of the likelihood deficit that retuning removes which may leave its beliefs for what they cost
    double hidden_by_retuning = 0.0;
    /// Where what is named only gives up beliefs that retuning has left, too. `retuned`, `held_out_retuned`,
    /// `mismatch`, channels and curves are of a retuned case then that keeps those within two tolerances.
    std::optional<FreelyRetuned> freely_retuned;
    bool per_value = false;                      ///< no time series: figures are per value, not per second
    std::vector<RetunedNumber> numbers;          ///< of the diagnosed case (of the retuned when nothing is named)
    std::vector<RetunedNumber> retuned_numbers;  ///< with nothing added: what calibration would have hidden
    std::vector<InferredCurve> curves;
    std::vector<ChannelComparison> channels;
    std::vector<Imperfection> imperfections;  ///< of the diagnosed case
    std::vector<UsedRecording> recordings;
    std::vector<std::string> not_tested;    ///< effects that could not be, and why
    std::vector<std::string> rests_on;      ///< what the verdict rests on: several speeds, a measured irregularity …
    std::vector<std::string> remains;       ///< what stays unexplained
    pem::CaseParameters diagnosed_numbers;  ///< the case before its effects, retuned
    std::vector<EffectInstance> diagnosed_effects;  ///< its own and the named ones
    Margins margins;
    double seconds_taken = 0.0;
};

}  // namespace railpem::diagnosis

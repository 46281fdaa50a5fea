#pragma once
// The believed case with something added, and its fit.

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/hypotheses/candidates.hpp"
#include "diagnosis/hypotheses/corrections.hpp"
#include "diagnosis/hypotheses/locate.hpp"

namespace railpem::diagnosis {

/// half of log 4: a number that is wrong mostly is so by a factor between a quarter and four
inline constexpr double kReleasedDeviation = 0.7;

/// A number as it is believed when it may be wrong: no less widely than before, and within what a wrong number is.
/// Masses, inertias, sections and contacts within a factor of four of their mean; stiffness, damping and loss, which
/// wear, break or were never measured, within ten; either within two deviations of its own belief where that is wider.
/// What would have to be further off is no wrong number, it stands in for something (a contact nine times as soft,
/// which no two curved pieces of steel make).
Unknown released(Unknown number);

/// A supposition that was fitted: effects added, numbers released from their tolerances, or a free correction of a
/// place.
struct FittedSet {
    std::vector<Candidate> effects;     ///< as started; the fitted values are in fit.trial.effects
    std::vector<std::string> released;  ///< keys of numbers whose belief was given up
    std::vector<CorrectionPlace> anonymous;
    bool beyond = false;  ///< anonymous: no correction, but effects beyond the range of their physics
    Fit fit;
    double log_prior = 0.0;
    double held_out = 0.0;  ///< log-likelihood of the held-out part
    double score() const { return fit.log_evidence + log_prior; }
    std::size_t members() const { return effects.size() + released.size(); }
};

/// Whether a set has these members, in this order, whatever their values.
bool has_members(const FittedSet& set, const std::vector<Candidate>& effects, const std::vector<std::string>& released);

/// What a fit of a set begins with.
struct Supposition {
    Trial trial;
    std::vector<Unknown> unknowns;
    std::vector<double> start;
};

/// A set before it is fitted, started near another fit, with the effects that are new at their own strength.
Supposition suppose(const BelievedCase& believed, const Fit& near, const std::vector<Candidate>& effects,
                    const std::vector<std::string>& released, const std::vector<CorrectionPlace>& anonymous,
                    const LikelihoodContext& context);

/// Fits a set from a fit that is near, with the effects at their starting strength.
FittedSet fit_set(const BelievedCase& believed, const Fit& near, std::vector<Candidate> effects,
                  std::vector<std::string> released, std::vector<CorrectionPlace> anonymous,
                  const LikelihoodContext& context, const FitOptions& options);

/// Fits the free correction of a place beside what a set has named, if anything, from where its promise at that set's
/// fit leads.
FittedSet fit_correction(const BelievedCase& believed, const FittedSet& beside, const LocatedEvidence& located,
                         const LikelihoodContext& context, const FitOptions& options);

/// The member of a set that leans most on its range; nullptr where fit_beyond_range() gives none.
const Candidate* leaning_member(const BelievedCase& believed, const FittedSet& leaning);

/// The member of a set that leans most on its range, alone and with its parameters widened by their range either way
/// (nothing that is positive falls below a fifth of its least): what the physics would have to be like that the set
/// imitates. An anonymous set, of that member's place and with the prior of an unknown; `beyond` is set. None where
/// what leans is a released number, and where that member is in the contact: steel on steel gives no more than its
/// range, and what distorts more is a nonlinearity that may be anywhere between wheel and ground (play of 0.1 mm in the
/// fastenings looked like a contact more than five times as nonlinear as Hertz's).
std::optional<FittedSet> fit_beyond_range(const BelievedCase& believed, const FittedSet& leaning,
                                          const LikelihoodContext& context, const FitOptions& options);

/// Nats that a set would gain, to second order, if one parameter of its effects could leave the range in which its
/// physics is believed, or one of its released numbers that of a wrong number: a fit that leans on such a bound says
/// that the physics is another. 0 when all lie inside.
double nats_beyond_range(const FittedSet& set);

/// The released number that gains most so: as a wrong number it would have to be further off than one is. Empty: none,
/// or what gains most is a parameter of an effect.
std::string number_beyond_range(const FittedSet& set);

/// Whether that parameter is a strength at the top of its range and would go, to second order, further beyond than its
/// law may be wrong: three times EffectParameter::inexact. Or a released number.
bool is_too_strong(const FittedSet& set);

/// Log-likelihood of a part at a fit's values.
double part_log_likelihood(const Fit& fit, const LikelihoodContext& context, Part part);

}  // namespace railpem::diagnosis

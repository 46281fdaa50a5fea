#pragma once
// The effects of the catalogue as hypotheses about a believed case and its recordings.

#include <string>
#include <vector>

#include "diagnosis/model/not_tested.hpp"
#include "diagnosis/model/trial.hpp"

namespace railpem::diagnosis {

/// A hypothesis about a believed case.
struct Candidate {
    EffectInstance instance;  ///< where a fit starts
    EffectInstance probe;     ///< where screening looks: all but nothing, or `instance` where strength adds power
    bool two_sided = false;   ///< the opposite sign of the strength is as believable
    bool whole = false;       ///< it cannot begin smaller than it stands in `probe`: there as a whole or not at all
    /// its values were read off the recordings: it starts there, however little of it the first order asks for
    bool read_off = false;
    double log_prior = 0.0;  ///< of this variant: the effect's, shared among its variants
};

struct CandidateList {
    std::vector<Candidate> candidates;
    std::vector<NotTested> not_tested;
};

/// All variants of all effects that the case allows and the recordings could show: each wheel and order whose line lies
/// in the band, each channel, each stage, and a grid over parameters that are no strength (frequencies, wavelengths).
/// Values beyond tolerance are not among them: the retuned fit tells those by itself.
CandidateList candidates(const BelievedCase& believed, const Trial& trial,
                         const std::vector<Observation>& observations);

/// The candidate started at `strength` probes (to first order), within its range: of what vanishes with its strength so
/// many steps from nothing, of what adds a power that much of it.
Candidate started_at(const Candidate& candidate, double strength);

/// The same effect in the same place: identifier and choices agree.
bool same_variant(const EffectInstance& first, const EffectInstance& second);

/// The identifier with its choices: "… (wheel 2, order 3)".
std::string label_of(const EffectInstance& instance);

}  // namespace railpem::diagnosis

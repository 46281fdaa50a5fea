#pragma once
// Fits of effects so strong that nothing near the retuned case leads to them.

#include <functional>

#include "diagnosis/hypotheses/naming_result.hpp"

namespace railpem::diagnosis {

/// What may be there without a derivative at nothing that leads to it: effects of places that are `evident`, and those
/// that follow the load, by effect, place and choice in the order of `candidates`; without what is in `members` as
/// often as it may be, sensors, irregularity and contact, and what comes in numbered variants, whose lines every
/// derivative sees.
std::vector<std::vector<Candidate>> variants_from_afar(const std::vector<Candidate>& candidates,
                                                       const std::vector<Candidate>& members,
                                                       const std::function<bool(Element)>& evident);

/// Every list of `variants` (one effect each, not empty) fitted beside `members` with a likelihood that is blunt enough
/// (a floor of 10 %) to have one broad maximum, in no order. Without any of them the case is fitted first, from `near`
/// (nothing: from the believed numbers, and members where their instances stand). Starts are typical values, either
/// ends of the ranges, and the frequencies of the variants, typical and strong; each is approached by the derivatives
/// of the case without it, and the best two climbed: with the numbers as believed a mass of 24 kg/m tuned to 49 Hz
/// ranked behind others at 79 to 127 Hz, and was lost. What cannot come near the best so far is given up. None where
/// physics forbids the members as they stand. `between` is called between steps with what is being fitted, and may
/// throw to stop. Where `enough` says so, all but the four most promising are left out, and always those of the others
/// whose best start lies below the case without them. So is what cannot come near the `rival`, a fit of the blunt
/// likelihood, if there is one.
std::vector<FittedSet> blunt_from_afar(
    const BelievedCase& believed, const Fit& near, const std::vector<Candidate>& members,
    const std::vector<std::vector<Candidate>>& variants, const LikelihoodContext& context,
    const std::function<void(const Candidate&)>& between, const std::function<bool()>& enough = [] { return false; },
    const Fit* rival = nullptr);

/// Free corrections of the places where the blunt likelihood finds most, fitted with it near the believed numbers, best
/// first: where retuning leaves much, its numbers are so far off that no step from there leads to what a place would
/// have to be (a linkage of the bogies, with two nodes an octave: nothing was left from here, 24 thousand nats from
/// there). `between` as above, with what is being done.
BluntCorrections blunt_corrections(const BelievedCase& believed, const LikelihoodContext& context,
                                   const std::function<void(const std::string&)>& between);

/// The best two of them, sharpened. The second only where it brings at least half as much bluntly and not `enough` is
/// done. What cannot come near the `rival`, a fit of the sharp likelihood, if there is one, is given up, and the second
/// where it cannot come near the first.
std::vector<FittedSet> sharpened_corrections(
    const BelievedCase& believed, const BluntCorrections& blunt, const LikelihoodContext& context,
    const std::function<void(const std::string&)>& between, const std::function<bool()>& enough = [] { return false; },
    const Fit* rival = nullptr);

/// The floor at which it shows whether a set that was fitted with the blunt likelihood is worth sharpening.
constexpr double kHalfSharpFloor = 0.04;

/// A set fitted with the blunt likelihood, sharpened to kHalfSharpFloor.
FittedSet half_sharpened(const BelievedCase& believed, const FittedSet& blunt, const LikelihoodContext& context,
                         const std::function<void()>& between);

/// The same sharpened to the end, in small steps; given up where it cannot come near `rival`, a fit of the sharp
/// likelihood, if there is one.
FittedSet sharpened(const BelievedCase& believed, const FittedSet& half_sharp, const LikelihoodContext& context,
                    const std::function<void()>& between, const Fit* rival = nullptr);

}  // namespace railpem::diagnosis

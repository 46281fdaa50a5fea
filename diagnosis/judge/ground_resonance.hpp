#pragma once
// Ground or pad: whether what each wheel meets by itself resonates.

#include <optional>

#include "diagnosis/judge/verdict.hpp"
#include "pem/case_parameters.hpp"

namespace railpem::diagnosis {

/// Frequency (Hz) of the node at which what each wheel meets by itself resonates: within the band the most, and a third
/// of it or less an octave away on either side (of two nodes that are nearly alike, of one beside them). None where it
/// rises to an end of the band or is broad, as what a play of the fastenings distorts. Nodes an octave apart, as
/// correction_nodes() has them. The bound is by judgement, in the middle of what was seen: play of 0.1 to 0.9 mm fell
/// by 1.1 at most, ground that wanders about 27 to 77 Hz by 4.7 at least (ten marched records).
std::optional<double> resonance_of(const pem::WheelsOwn& own);

/// To a uniform track pads and ground in series are one, and rigid ground has no correction of its own. But a pad has
/// no mass: what differs from wheel to wheel at the pads and resonates is of the ground. Its place is the support then:
/// of the fit, and with as much evidence as at the pads of what the retuned case leaves.
void tell_ground_from_pads(PlaceStudy& study);

}  // namespace railpem::diagnosis

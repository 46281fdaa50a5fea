#pragma once
// Distances whose lines are partly those of another distance.

#include <limits>
#include <vector>

#include "diagnosis/effects/effect.hpp"
#include "diagnosis/observations/observation.hpp"

namespace railpem::diagnosis {

/// Longest distance whose lines the windows of all recordings tell apart. A comb that is denser in one of them is there
/// a noise of any shape, and was named for what the model lacked: every 42.5 m (a null), 55 m (stiffer pads) and 64 m
/// (a wheel flat), at 15 m/s and more with windows of 4 s.
double longest_comb_m(const std::vector<Observation>& observations);

/// A comb of lines at n·v/d is met halfway by one of d/2 and wholly by one of 4·d: a fit that starts from afar ends in
/// any of them. The fitted instance with such a distance (EffectParameter::comb) divided by 2 to 5 and multiplied by 2
/// and 3; the strength in the same ratio, so that the lines that both have stay as they are. Empty for effects without
/// a comb; distances beyond the range of the effect are left out.
std::vector<EffectInstance> comb_relatives(const EffectInstance& fitted,
                                           double longest_m = std::numeric_limits<double>::infinity());

/// The fitted instance with lines where there should be none: its distance 1.037 times as long and as short. What gains
/// as much there is no comb. Empty for effects without one.
std::vector<EffectInstance> comb_decoys(const EffectInstance& fitted);

}  // namespace railpem::diagnosis

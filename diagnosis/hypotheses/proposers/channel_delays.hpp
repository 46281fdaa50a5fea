#pragma once
// How late a channel is, when it is later than a derivative could tell.

#include <cstddef>
#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/hypotheses/candidates.hpp"

namespace railpem::diagnosis {

/// The delay at which what a channel measured agrees best with what the others and the fit say of it, s, between
/// −`longest_s` and that, to an eighth of the shortest period of the band; positive: the channel is late. With w =
/// S_co·S_oo⁻¹ of the fit, x̂_c = w·x_o is the most that all other channels say of channel c, and the coherence of the
/// two has the phase of the delay: its real part, turned back, is summed over bins and recordings with the weight
/// |γ|²/(1 − |γ|²) of a phase (Bendat & Piersol 2010, Random Data, chapter 9). Zero where no recording has the
/// response.
double channel_delay_s(const Fit& fit, const LikelihoodContext& context, std::size_t response, double longest_s);

/// Gives every channel that can be late a companion that is so by the delay found, where a derivative at
/// nothing does not lead there. `candidates` keeps one for each delay.
void add_delays(const Fit& fit, const LikelihoodContext& context, std::vector<Candidate>& candidates);

}  // namespace railpem::diagnosis

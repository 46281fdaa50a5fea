#pragma once
// Where the mounting of a sensor resonates, when it does so more sharply than a grid of frequencies finds.

#include <optional>
#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/hypotheses/candidates.hpp"

namespace railpem::diagnosis {

struct ChannelResonance {
    double frequency_hz = 0.0;
    double damping_ratio = 0.0;
};

/// The frequency at which a channel reads most beyond what the others and the fit say of it, and the damping ratio of a
/// single degree of freedom that amplifies as much, 1/(2|g|); none where it nowhere reads twice as much, or no
/// recording has the response. With w = S_co·S_oo⁻¹ of the fit, x̂_c = w·x_o is the most that all other channels say of
/// channel c, and g = E[x_c·x̂_c*]/E|x̂_c|² its transfer to what was measured, over all recordings (H₁, Bendat & Piersol
/// 2010, Random Data, chapter 6): what is not in x̂_c is averaged out, and what moves the neighbours as well is no
/// sensor's.
std::optional<ChannelResonance> channel_resonance(const Fit& fit, const LikelihoodContext& context,
                                                  std::size_t response);

/// Gives every channel whose mounting can resonate a companion that does so where it was found.
/// `candidates` keeps one for each frequency.
void add_resonances(const Fit& fit, const LikelihoodContext& context, std::vector<Candidate>& candidates);

}  // namespace railpem::diagnosis

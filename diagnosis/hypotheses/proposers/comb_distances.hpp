#pragma once
// Distances at which something repeats along the rail, found by its lines.

#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/hypotheses/candidates.hpp"

namespace railpem::diagnosis {

/// Dips every `spacing_m` of `length_m`, and what their lines promise.
struct CombDistance {
    double spacing_m = 0.0, length_m = 0.0;
    double nats = 0.0;
};

/// Distances between dips (spectra/rail_joint_lines) from `shortest_m` to `longest_m` whose lines explain most of what
/// a fit leaves: at most `most`, best first, none within 2 % of a better one. A derivative leads to a distance only
/// from where the highest line lies within a bin of its place already, some 0.1 %, so the score of a line's power,
/// n·uᴴRu with u = L⁻¹t, t the response to a unit wave at the bin, is taken once for every bin, and thousands of combs
/// are added up from it.
std::vector<CombDistance> comb_distances(const Fit& fit, const LikelihoodContext& context, double shortest_m,
                                         double longest_m, std::size_t most);

/// Gives every candidate whose effect has a distance (EffectParameter::comb) companions at the distances that the fit's
/// misfit promises.
void add_combs(const Fit& fit, const LikelihoodContext& context, std::vector<Candidate>& candidates);

}  // namespace railpem::diagnosis

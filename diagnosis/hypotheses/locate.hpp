#pragma once
// Which place of the structure a free correction would have to be at.

#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/hypotheses/corrections.hpp"
#include "diagnosis/hypotheses/screen.hpp"

namespace railpem::diagnosis {

/// Evidence to first order of a free correction at one place, everything that the fit moves projected out.
struct LocatedEvidence {
    CorrectionPlace place;
    double nats = 0.0;
    FreedomPromise promise;  ///< of correction_unknowns(place)
};

/// Every element of the structure with its best place (the best channel for sensors), most evident first.
std::vector<LocatedEvidence> locate(const Fit& fit, const LikelihoodContext& context);

/// Whether a place of the structure is evident among those that are `left`: a tenth of the most evident one's nats, and
/// no less than `chance` if that itself is as little. Sensors do not count: free at every frequency, one imitates what
/// its channel shows most.
bool is_evident_among(const std::vector<LocatedEvidence>& left, Element element, double chance);

}  // namespace railpem::diagnosis

#pragma once
// What free corrections do to the predictions.

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/hypotheses/corrections.hpp"

namespace railpem::diagnosis {

/// Derivatives with every unknown of correction_unknowns(place) at a fit's values, in that order. Above the rail one is
/// taken for every part of the curve as a whole, and shared among its nodes bin by bin: a correction acts at its own
/// frequency. What it does elsewhere (by the bins' window, dry friction whose damping follows the whole vibration) is
/// put down to the node of the frequency where it shows. Of rail, pads and support, and of scalar recordings, one for
/// every node.
std::vector<PredictionDerivative> correction_derivatives(const Fit& fit, const CorrectionPlace& place,
                                                         const LikelihoodContext& context);

}  // namespace railpem::diagnosis

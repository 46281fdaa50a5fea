#pragma once
// The dynamic stiffness (or mass) that the recordings infer at a place.

#include <optional>

#include "diagnosis/findings/diagnosis.hpp"
#include "diagnosis/fit/fit.hpp"
#include "diagnosis/hypotheses/corrections.hpp"
#include "diagnosis/observations/believed_case.hpp"

namespace railpem::diagnosis {

/// The law of a place in a case at a frequency: N/m of suspensions, pad, support and contact, kg of body, bogie, wheel
/// and (per metre) rail. Free corrections are not in it. Nothing where a place has no such law (irregularity, sensor).
std::optional<std::complex<double>> place_law(const pem::CaseParameters& parameters, Element element,
                                              double frequency_hz);

/// Law times free correction from a fit that has one at this place, with its 90 % band from the joint covariance.
InferredCurve inferred_curve(const Fit& anonymous, const CorrectionPlace& place, const BelievedCase& believed,
                             const std::vector<Observation>& observations);

/// The law of a fit on the frequencies of a curve.
std::vector<std::complex<double>> law_of(const Fit& fit, const InferredCurve& curve, const BelievedCase& believed,
                                         const std::vector<Observation>& observations);

}  // namespace railpem::diagnosis

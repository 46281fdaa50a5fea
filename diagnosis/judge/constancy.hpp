#pragma once
// Whether what an effect's parameter is believed to be is the same in every recording.

#include <string>
#include <vector>

#include "diagnosis/fit/fit.hpp"

namespace railpem::diagnosis {

/// One parameter of an effect as each recording by itself would have it.
struct ParameterByRecording {
    std::size_t unknown = 0;               ///< of the fit
    std::vector<std::size_t> observation;  ///< those that speak of it
    std::vector<double> value;             ///< in each of them, to first order
    double nats = 0.0;                     ///< by which they disagree beyond what the law gets wrong
};

/// Physics is the same at every speed and load; a law that only imitates what is there has another strength in each
/// recording. For every continuous parameter of the effects of a fit that more than one time series speaks of, the
/// differences Δ of its values from recording to recording to first order, all other unknowns free (the common value
/// among them), with their covariance C: ½ Δᵀ(C + V)⁻¹Δ nats speak against one value, V what the law gets wrong
/// (law_deviation(), at least a hundredth of the value), another amount in each recording. By chance it is half a χ² of
/// as many degrees of freedom as there are recordings, less one.
std::vector<ParameterByRecording> constancy(const Fit& fit, const LikelihoodContext& context);

}  // namespace railpem::diagnosis

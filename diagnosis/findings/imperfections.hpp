#pragma once
// What of the recordings the class of models does not have and no name is needed for.

#include <string>
#include <vector>

#include "diagnosis/fit/fit.hpp"

namespace railpem::diagnosis {

/// Where something that the model does not have enters, and how much of the power it is.
struct Imperfection {
    std::string where;                                   ///< "wheel" or "sensor"
    std::string channel;                                 ///< of a sensor; empty for the wheels together
    double share_of_power = 0.0, low = 0.0, high = 0.0;  ///< with 90 % interval
    std::string says;                                    ///< one sentence
};

/// Of a fit: what each wheel meets alone, as a share of the irregularity's power averaged over its wavelengths in the
/// logarithm; of every sensor its own noise and what no other channel shares, as a share of the power of its channel
/// over the band (the recording where that is largest), with its calibration. Empty without time series.
std::vector<Imperfection> imperfections(const Fit& fit, const std::vector<Observation>& observations);

}  // namespace railpem::diagnosis

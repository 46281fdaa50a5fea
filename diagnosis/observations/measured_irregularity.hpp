#pragma once
// What a measured running surface says of the irregularity, in the terms in which the diagnosis is unsure of it.

#include <vector>

#include "recordings/measured_irregularity.hpp"
#include "spectra/irregularity_parameters.hpp"

namespace railpem::diagnosis {

/// Belief in the logarithm of the factor on the believed spectrum around one wavelength.
struct NodeBelief {
    double mean = 0.0;
    double deviation = 0.0;
    bool measured = false;  ///< false: the measurements do not reach this wavelength, and the rest means nothing
};

/// Beliefs at `wavelengths_m` (increasing): the logarithm of measured over believed power within half the distance to
/// the neighbours. Of profiles the deviation is 1/√(averages × lines) of what was averaged, of spectra, which do not
/// say what they rest on, 0.1; never below 0.02, what a running surface changes between two runs. Several measurements
/// are weighted with their precision.
std::vector<NodeBelief> node_beliefs(const spectra::IrregularityParameters& believed,
                                     const std::vector<recordings::MeasuredIrregularity>& measured,
                                     const std::vector<double>& wavelengths_m);

}  // namespace railpem::diagnosis

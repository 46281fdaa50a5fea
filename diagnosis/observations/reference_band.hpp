#pragma once

#include "pem/case_parameters.hpp"

namespace railpem::diagnosis {

/// Element of the reference at a third-octave, or −1.
int reference_band(const pem::DecayRateReference& reference, double frequency_hz);

}  // namespace railpem::diagnosis

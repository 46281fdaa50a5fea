#pragma once
// What of an irregularity a speed turns into frequencies that are looked at.

#include "pem/case_parameters.hpp"

namespace railpem::app {

/// NaN and 0 where there is nothing of it.
struct ExcitedBand {
    double from_hz, to_hz;  ///< the lowest and the highest frequency with any power
    double rms_m;           ///< of the broadband irregularity between them
};

/// Between low_hz and high_hz > low_hz > 0. The rms is integrated on lines of its own, within 1e-4.
ExcitedBand excited_band(const pem::CaseParameters& parameters, double speed_m_per_s, double low_hz, double high_hz);

}  // namespace railpem::app

#pragma once

#include <string>

#include "recordings/checks/inspection_context.hpp"

namespace railpem::recordings {

/// What a frequency may be at this speed, within the speed's uncertainty: "sleeper passing, order 2", "wheel order 3";
/// empty when neither spacing nor radius is known, the speed is 0, or nothing fits. Orders up to 6 of the sleepers and
/// 20 of the wheels.
std::string name_of_order(double frequency_hz, double speed_m_per_s, double speed_error_m_per_s,
                          const InspectionContext& context);

/// The same, with mains frequencies tried as well; "" when nothing fits.
std::string name_of_line(double frequency_hz, double speed_m_per_s, double speed_error_m_per_s,
                         const InspectionContext& context);

}  // namespace railpem::recordings

#pragma once

namespace railpem::recordings::checks {

inline constexpr double false_alarm = 1e-6;  ///< of a test that stands for itself, in a sound record

}  // namespace railpem::recordings::checks

#pragma once
// Complex numbers per wheel and per pair of wheels, a group of frequency lines side by side.

#include <array>

#include "lanes/complex_lanes.hpp"

namespace railpem::pem {

using WheelVector = std::array<lanes::Complex, 4>;
using WheelMatrix = std::array<WheelVector, 4>;  ///< [row][column]

}  // namespace railpem::pem

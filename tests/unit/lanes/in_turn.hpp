#pragma once
// Numbers for as many lanes as the program was built with.

#include <cstddef>
#include <initializer_list>

#include "lanes/complex_lanes.hpp"

namespace railpem::lanes::tests {

/// `values` one after the other, from the first again where there are more lanes.
inline Real in_turn(std::initializer_list<double> values) {
    Real lanes;
    for (int lane = 0; lane < width; ++lane)
        lanes[lane] = values.begin()[static_cast<std::size_t>(lane) % values.size()];
    return lanes;
}

}  // namespace railpem::lanes::tests

#pragma once
// The fine frequency lines of an expectation, between the bins of the estimate.

#include <cstddef>

#include "recordings/estimates/window.hpp"

namespace railpem::diagnosis {

/// Uniform frequencies.
struct FineGrid {
    double step_hz;
    std::size_t first, count;  ///< indices from frequency 0
    double frequency(std::size_t i) const { return static_cast<double>(first + i) * step_hz; }
};

/// The fine lines that count for `bins` bins from `first_bin` on.
FineGrid fine_grid(const recordings::WindowKernel& kernel, std::size_t first_bin, std::size_t bins, int oversampling);

}  // namespace railpem::diagnosis

#pragma once
// The window's kernel over the cross-spectra of one source: the inner loop of every expectation.

#include <complex>
#include <cstddef>
#include <vector>

#include "recordings/estimates/window.hpp"

namespace railpem::diagnosis {

/// Where fine lines and bins lie: fine line i is at (first + i) fine steps, bin b at (first_bin + b)·oversampling of
/// them.
struct SmoothingGrid {
    std::size_t first = 0, count = 0;  ///< fine lines
    std::size_t first_bin = 0, bins = 0;
};

/// Adds ∫K(f − f′) y(f′)y(f′)ᴴ df′ of a rank-one source to `matrices`, [bin][column-major channels × channels].
/// `responses` is [rank][channel][fine line], and the products of all ranks add up; beyond the fine lines the source
/// has nothing.
void add_smoothed(const std::vector<std::complex<double>>& responses, std::size_t channels,
                  const recordings::KernelWeights& kernel, const SmoothingGrid& grid,
                  std::vector<std::complex<double>>& matrices);

}  // namespace railpem::diagnosis

#include "diagnosis/expectation/fine_grid.hpp"

#include "diagnosis/expectation/expectation_settings.hpp"

namespace railpem::diagnosis {

FineGrid fine_grid(const recordings::WindowKernel& kernel, std::size_t first_bin, std::size_t bins, int oversampling) {
    const std::size_t reach =
        static_cast<std::size_t>(kExpectationSettings.kernel_reach_bins) * static_cast<std::size_t>(oversampling);
    const std::size_t low = first_bin * static_cast<std::size_t>(oversampling);
    const std::size_t first = low > reach ? low - reach : 1;
    const std::size_t last = (first_bin + bins - 1) * static_cast<std::size_t>(oversampling) + reach;
    return {kernel.bin_hz() / oversampling, first, last - first + 1};
}

}  // namespace railpem::diagnosis

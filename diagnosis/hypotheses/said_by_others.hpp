#pragma once
// What all other channels of a recording say of one of them.

#include <complex>
#include <cstddef>
#include <functional>

#include "diagnosis/fit/fit.hpp"

namespace railpem::diagnosis {

/// Of one channel at one bin of one recording. The best linear estimate of a channel from the others, x̂ = wᴴ·x, has of
/// the inverse of the expected matrix S its column: w = −S⁻¹e/(eᴴS⁻¹e), and nothing of the channel itself.
struct SaidByOthers {
    std::size_t response = 0;  ///< pem::response_index
    double frequency_hz = 0.0;
    std::complex<double> cross;  ///< of what is said with what was measured
    double said = 0.0;           ///< power of what is said; units of the channel's spectrum, as those that follow
    double measured = 0.0;       ///< and of what was measured
    double expected = 0.0;       ///< and of what the fit expects
};

/// Calls `with` for every channel at every bin of every recording that has two or more, in their order.
void for_each_said_by_others(const Fit& fit, const LikelihoodContext& context,
                             const std::function<void(const SaidByOthers&)>& with);

}  // namespace railpem::diagnosis

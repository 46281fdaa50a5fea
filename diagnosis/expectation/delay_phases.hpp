#pragma once
// The delays between the wheels along a grid of frequencies.

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "diagnosis/expectation/fine_grid.hpp"
#include "pem/coupling/excitation.hpp"

namespace railpem::diagnosis {

/// Delays of the wheels along the fine grid: each line's from that of the line before, taken anew often enough for
/// rounding not to add up.
class DelayPhases {
  public:
    DelayPhases(const std::vector<double>& wheels_m, double speed_m_per_s, const FineGrid& grid)
        : wheels_(wheels_m), speed_(speed_m_per_s), grid_(grid) {
        for (std::size_t j = 0; j < 4; ++j) turn_[j] = pem::delay_phase(wheels_, j, grid.step_hz, speed_);
    }

    /// Those of line `i`; lines one after the other, none left out.
    const std::array<std::complex<double>, 4>& at(std::size_t i) {
        constexpr std::size_t kAnew = 32;  ///< lines: 32 roundings are some 1e-15
        for (std::size_t j = 0; j < 4; ++j) {
            const std::complex<double>& p = phase_[j];
            const std::complex<double>& t = turn_[j];
            phase_[j] = i % kAnew == 0 ? pem::delay_phase(wheels_, j, grid_.frequency(i), speed_)
                                       : std::complex<double>(p.real() * t.real() - p.imag() * t.imag(),
                                                              p.real() * t.imag() + p.imag() * t.real());
        }
        return phase_;
    }

  private:
    const std::vector<double>& wheels_;
    double speed_;
    FineGrid grid_;
    std::array<std::complex<double>, 4> turn_{}, phase_{};
};

}  // namespace railpem::diagnosis

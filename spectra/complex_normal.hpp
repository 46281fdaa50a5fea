#pragma once
// Random numbers of which spectra are drawn.

#include <cmath>
#include <complex>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <random>

namespace railpem::spectra {

/// Standard complex Gaussian numbers, E|z|² = 1 (Box & Muller 1958; the same on every machine).
class ComplexNormal {
  public:
    explicit ComplexNormal(std::initializer_list<std::uint32_t> words) {
        std::seed_seq seed(words);
        random_.seed(seed);
    }
    std::complex<double> operator()() {
        const double radius = std::sqrt(-std::log1p(-unit()));
        return std::polar(radius, 2.0 * std::numbers::pi * unit());
    }

  private:
    double unit() { return static_cast<double>(random_() >> 11) * 0x1.0p-53; }
    std::mt19937_64 random_;
};

}  // namespace railpem::spectra

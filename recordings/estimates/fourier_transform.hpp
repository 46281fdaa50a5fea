#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

namespace railpem::recordings {

/// Discrete Fourier transform of real sequences of one even length, double precision (kissfft, BSD).
///   X_k = Σ_n x_n e^{−2πikn/N}, k = 0 … N/2;  the inverse carries the 1/N.
/// Fast when N has no prime factor above 5. An object belongs to one thread.
class FourierTransform {
  public:
    explicit FourierTransform(std::size_t length);  ///< even, at least 4 (assert)
    ~FourierTransform();
    FourierTransform(FourierTransform&&) noexcept;
    FourierTransform& operator=(FourierTransform&&) noexcept;

    std::size_t length() const { return length_; }
    std::size_t bins() const { return length_ / 2 + 1; }

    void forward(const double* samples, std::complex<double>* spectrum) const;  ///< length() in, bins() out
    void inverse(const std::complex<double>* spectrum, double* samples) const;  ///< bins() in, length() out

  private:
    struct Plan;
    std::size_t length_;
    std::unique_ptr<Plan> plan_;
};

/// Smallest even number ≥ n (and ≥ 4) with no prime factor above 5.
std::size_t fast_length(std::size_t n);

}  // namespace railpem::recordings

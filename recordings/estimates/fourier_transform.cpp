#include "recordings/estimates/fourier_transform.hpp"

#include <cassert>
#include <cmath>
#include <kissfft/kissfft.hh>

namespace railpem::recordings {

struct FourierTransform::Plan {
    explicit Plan(std::size_t half) : forward(half, false), backward(half, true), work(half + 1), half_work(half) {}
    kissfft<double> forward, backward;
    std::vector<std::complex<double>> work, half_work;
};

FourierTransform::FourierTransform(std::size_t length) : length_(length) {
    assert(length >= 4 && length % 2 == 0);
    plan_ = std::make_unique<Plan>(length / 2);
}
FourierTransform::~FourierTransform() = default;
FourierTransform::FourierTransform(FourierTransform&&) noexcept = default;
FourierTransform& FourierTransform::operator=(FourierTransform&&) noexcept = default;

void FourierTransform::forward(const double* samples, std::complex<double>* spectrum) const {
    const std::size_t half = length_ / 2;
    plan_->forward.transform_real(samples, plan_->work.data());
    // The first bin comes packed: constant term in the real part, term at half the sampling rate in the imaginary part.
    spectrum[0] = plan_->work[0].real();
    spectrum[half] = plan_->work[0].imag();
    for (std::size_t k = 1; k < half; ++k) spectrum[k] = plan_->work[k];
}

void FourierTransform::inverse(const std::complex<double>* spectrum, double* samples) const {
    // The even and odd samples as real and imaginary part of one sequence of half the length.
    const std::size_t half = length_ / 2;
    const double step = 2.0 * std::acos(-1.0) / static_cast<double>(length_);
    for (std::size_t k = 0; k < half; ++k) {
        const std::complex<double> a = spectrum[k], b = std::conj(spectrum[half - k]);
        const std::complex<double> even = a + b, odd = (a - b) * std::polar(1.0, step * static_cast<double>(k));
        plan_->half_work[k] = even + std::complex<double>(0.0, 1.0) * odd;
    }
    plan_->backward.transform(plan_->half_work.data(), plan_->work.data());
    const double scale = 1.0 / static_cast<double>(length_);
    for (std::size_t n = 0; n < half; ++n) {
        samples[2 * n] = scale * plan_->work[n].real();
        samples[2 * n + 1] = scale * plan_->work[n].imag();
    }
}

std::size_t fast_length(std::size_t n) {
    for (std::size_t length = std::max<std::size_t>(4, n + n % 2);; length += 2) {
        std::size_t rest = length;
        for (const std::size_t prime : {2, 3, 5})
            while (rest % prime == 0) rest /= prime;
        if (rest == 1) return length;
    }
}

}  // namespace railpem::recordings

#include "diagnosis/expectation/kernel_smoothing.hpp"

#include <cstring>

#include "lanes/complex_lanes.hpp"

namespace railpem::diagnosis {

namespace {

constexpr std::size_t kLanes = 4 * lanes::width;  ///< bins side by side

/// One part of a response in `oversampling` interleaved sequences, so that neighbouring bins read neighbouring numbers.
/// Zeros stand before and behind where the kernel reaches beyond the fine lines.
class Polyphase {
  public:
    Polyphase(const recordings::KernelWeights& kernel, const SmoothingGrid& grid)
        : oversampling_(static_cast<std::size_t>(kernel.oversampling)),
          reach_(static_cast<std::size_t>(kernel.reach_bins) * oversampling_),
          length_(((grid.bins + kLanes - 1) / kLanes) * kLanes + 2 * static_cast<std::size_t>(kernel.reach_bins) + 1),
          offset_(static_cast<long>(grid.first_bin * oversampling_) - static_cast<long>(reach_) -
                  static_cast<long>(grid.first)) {
        for (std::size_t t = 0; t < kernel.weights.size(); ++t) taps_.push_back(tap(t));
    }

    std::size_t size() const { return length_ * oversampling_; }
    /// Place of tap t = 0 … 2·reach at bin 0; bin b is b further.
    std::size_t tap(std::size_t t) const { return (t % oversampling_) * length_ + t / oversampling_; }
    const std::vector<std::size_t>& taps() const { return taps_; }
    /// Spreads a response; `re` and `im` hold size() zeros.
    void spread(const std::complex<double>* response, std::size_t count, double* re, double* im) const {
        for (std::size_t t = 0; t < length_ * oversampling_; ++t) {
            const long fine = offset_ + static_cast<long>(t);
            if (fine < 0 || fine >= static_cast<long>(count)) continue;
            re[tap(t)] = response[fine].real();
            im[tap(t)] = response[fine].imag();
        }
    }

  private:
    std::size_t oversampling_, reach_, length_;
    std::vector<std::size_t> taps_;
    long offset_;  ///< fine line of tap 0 at bin 0
};

lanes::Real load(const double* from) {
    lanes::Real value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

/// Weighted sums over the taps for kLanes bins from `bin` on.
void sum_taps(const recordings::KernelWeights& kernel, const Polyphase& order, const double* values, std::size_t bin,
              double* sum) {
    lanes::Real a{}, b{}, c{}, d{};  // in registers; an array would not stay there
    constexpr std::ptrdiff_t width = lanes::width;
    for (std::size_t t = 0; t < kernel.weights.size(); ++t) {
        const double* x = values + order.taps()[t] + bin;
        a += kernel.weights[t] * load(x);
        b += kernel.weights[t] * load(x + width);
        c += kernel.weights[t] * load(x + 2 * width);
        d += kernel.weights[t] * load(x + 3 * width);
    }
    std::memcpy(sum, &a, sizeof a);
    std::memcpy(sum + width, &b, sizeof b);
    std::memcpy(sum + 2 * width, &c, sizeof c);
    std::memcpy(sum + 3 * width, &d, sizeof d);
}

}  // namespace

void add_smoothed(const std::vector<std::complex<double>>& responses, std::size_t channels,
                  const recordings::KernelWeights& kernel, const SmoothingGrid& grid,
                  std::vector<std::complex<double>>& matrices) {
    const Polyphase order(kernel, grid);
    const std::size_t size = order.size(), ranks = responses.size() / (channels * grid.count), rows = ranks * channels;
    std::vector<double> re(rows * size, 0.0), im(rows * size, 0.0), product_re(size), product_im(size);
    for (std::size_t row = 0; row < rows; ++row)
        order.spread(&responses[row * grid.count], grid.count, &re[row * size], &im[row * size]);
    for (std::size_t a = 0; a < channels; ++a)
        for (std::size_t b = 0; b <= a; ++b) {
            for (std::size_t rank = 0; rank < ranks; ++rank) {
                const double *ar = &re[(rank * channels + a) * size], *ai = &im[(rank * channels + a) * size],
                             *br = &re[(rank * channels + b) * size], *bi = &im[(rank * channels + b) * size];
                if (rank == 0)
                    for (std::size_t i = 0; i < size; ++i) {
                        product_re[i] = ar[i] * br[i] + ai[i] * bi[i];
                        product_im[i] = ai[i] * br[i] - ar[i] * bi[i];
                    }
                else
                    for (std::size_t i = 0; i < size; ++i) {
                        product_re[i] += ar[i] * br[i] + ai[i] * bi[i];
                        product_im[i] += ai[i] * br[i] - ar[i] * bi[i];
                    }
            }
            for (std::size_t bin = 0; bin < grid.bins; bin += kLanes) {
                double sum_re[kLanes], sum_im[kLanes];
                sum_taps(kernel, order, product_re.data(), bin, sum_re);
                sum_taps(kernel, order, product_im.data(), bin, sum_im);
                for (std::size_t l = 0; l < kLanes && bin + l < grid.bins; ++l) {
                    std::complex<double>* matrix = &matrices[(bin + l) * channels * channels];
                    matrix[b * channels + a] += std::complex<double>(sum_re[l], sum_im[l]);
                    if (a != b) matrix[a * channels + b] += std::complex<double>(sum_re[l], -sum_im[l]);
                }
            }
        }
}

}  // namespace railpem::diagnosis

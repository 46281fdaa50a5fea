#include "recordings/estimates/delay.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>

#include "recordings/estimates/confidence.hpp"
#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/estimates/fourier_transform.hpp"

namespace railpem::recordings {
namespace {

using Complex = std::complex<double>;
constexpr double two_pi = 2.0 * std::numbers::pi;

/// Coherence beyond which a bin gets no more weight: there the ripple of the phase, not its noise, limits the estimate.
constexpr double most_coherence = 0.95;

CrossSpectra pair_spectra(const std::vector<double>& a, const std::vector<double>& b, double rate, double window_s) {
    TimeSeries pair;
    pair.sampling_rate_hz = rate;
    pair.channels = {{{}, a}, {{}, b}};
    return estimate_cross_spectra(pair, {.window_s = window_s});
}

struct Peak {
    double delay_s = 0.0;
    double value = 0.0;       ///< signed correlation at the peak
    double deviations = 0.0;  ///< height in standard deviations of the correlation elsewhere
    double tests = 1.0;
};

/// Largest magnitude of the whitened correlation within the range, from the record as a whole (zero-padded, so that no
/// delay wraps round): both channels divided by the root of their own smoothed spectra.
Peak whitened_peak(const std::vector<double>& earlier, const std::vector<double>& later, double rate,
                   const DelayOptions& options, double highest) {
    const FourierTransform transform(fast_length(
        earlier.size() +
        static_cast<std::size_t>(std::ceil(std::max(std::abs(options.least_s), std::abs(options.most_s)) * rate)) + 1));
    const std::size_t length = transform.length();
    const double window_s = std::min(1.0, static_cast<double>(earlier.size()) / rate / 8.0);
    const CrossSpectra smooth = pair_spectra(earlier, later, rate, window_s);
    std::vector<Complex> a(transform.bins()), b(transform.bins());
    std::vector<double> padded(length, 0.0);
    std::copy(earlier.begin(), earlier.end(), padded.begin());
    transform.forward(padded.data(), a.data());
    std::copy(later.begin(), later.end(), padded.begin());
    transform.forward(padded.data(), b.data());
    double used = 0.0;
    const double bin_hz = rate / static_cast<double>(length);
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double f = static_cast<double>(k) * bin_hz;
        const auto at =
            std::min(smooth.bins() - 1, static_cast<std::size_t>(std::lround(f / smooth.kernel().bin_hz())));
        const double power = smooth.psd(at, 0) * smooth.psd(at, 1);
        if (f < options.from_hz || f > highest || power <= 0.0) {
            a[k] = 0.0;
            continue;
        }
        a[k] *= std::conj(b[k]) / std::sqrt(power);
        used += 1.0;
    }
    if (used <= 0.0) return {};
    std::vector<double> correlation(length);
    transform.inverse(a.data(), correlation.data());
    // |X|² has the mean S f_s N/2, N samples without the padding.
    const double scale = static_cast<double>(length) / (used * rate * static_cast<double>(earlier.size()));
    Peak peak;
    std::vector<double> magnitudes;
    const auto from = static_cast<long>(std::floor(options.least_s * rate)),
               to = static_cast<long>(std::ceil(options.most_s * rate));
    for (long lag = from; lag <= to; ++lag) {
        // Channel 1 later by lag: the cross-spectrum S_01 has the phase +ω·lag, so its peak stands at −lag.
        const auto at = static_cast<std::size_t>(((-lag) % static_cast<long>(length) + static_cast<long>(length)) %
                                                 static_cast<long>(length));
        const double value = scale * correlation[at];
        magnitudes.push_back(std::abs(value));
        if (std::abs(value) > std::abs(peak.value)) peak = {static_cast<double>(lag) / rate, value, 0.0, 0.0};
    }
    // Scatter within the range by the median, which no peak disturbs.
    const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
    std::nth_element(magnitudes.begin(), middle, magnitudes.end());
    peak.deviations = 0.6745 * std::abs(peak.value) / std::max(1e-300, *middle);
    peak.tests = static_cast<double>(to - from + 1);
    return peak;
}

/// Phase line through the cross-spectrum of two channels that are nearly on top of each other.
struct PhaseLine {
    double delay_s = 0.0;
    double bound_s = 0.0;    ///< Cramér–Rao
    double scatter_s = 0.0;  ///< from the scatter of the phases about the line
    double correlation = 0.0;
};

PhaseLine fit_phase_line(const CrossSpectra& spectra, double sign, const DelayOptions& options, double highest,
                         double block_hz) {
    struct Bin {
        double omega, weight;
        Complex direction;
    };
    std::vector<Bin> bins;
    const double averages = std::max(2.0, spectra.averages);
    double information = 0.0, total = 0.0;
    for (std::size_t k = 1; k + 1 < spectra.bins(); ++k) {
        if (spectra.frequency_hz[k] < options.from_hz || spectra.frequency_hz[k] > highest) continue;
        const double biased = spectra.coherence(k, 0, 1);
        const double coherence = std::min(most_coherence, (biased - 1.0 / averages) / (1.0 - 1.0 / averages));
        if (coherence <= 0.0) continue;
        const double omega = two_pi * spectra.frequency_hz[k], weight = coherence / (1.0 - coherence);
        bins.push_back({omega, weight, sign * spectra.at(k, 0, 1) / std::abs(spectra.at(k, 0, 1))});
        information += 2.0 * spectra.averages_per_bin * weight * omega * omega;
        total += weight;
    }
    PhaseLine line;
    if (bins.size() < 4) return line;
    const auto slope = [&](double tau, double& curvature) {
        double gradient = 0.0;
        curvature = 0.0;
        for (const Bin& bin : bins) {
            const Complex turned = bin.direction * std::polar(1.0, -bin.omega * tau);
            gradient += bin.weight * bin.omega * turned.imag();
            curvature += bin.weight * bin.omega * bin.omega * turned.real();
        }
        return gradient;
    };
    double curvature = 0.0;
    for (int iteration = 0; iteration < 20; ++iteration) {
        const double gradient = slope(line.delay_s, curvature);
        if (!(curvature > 0.0)) break;
        const double step = std::clamp(gradient / curvature, -5e-4, 5e-4);
        line.delay_s += step;
        if (std::abs(step) < 1e-12) break;
    }
    slope(line.delay_s, curvature);
    double scatter = 0.0, block = 0.0, block_end = 0.0, aligned = 0.0;
    for (const Bin& bin : bins) {
        const Complex turned = bin.direction * std::polar(1.0, -bin.omega * line.delay_s);
        if (bin.omega >= block_end) {
            scatter += block * block;
            block = 0.0;
            block_end = bin.omega + two_pi * block_hz;
        }
        block += bin.weight * bin.omega * turned.imag();
        aligned += bin.weight * turned.real();
    }
    scatter += block * block;
    line.bound_s = 1.0 / std::sqrt(information);
    line.scatter_s = curvature > 0.0 ? std::sqrt(scatter) / curvature : 1.0;
    line.correlation = aligned / total;
    return line;
}

/// Both channels shortened so that sample n of one meets sample n + shift of the other.
void shift_together(std::vector<double>& earlier, std::vector<double>& later, long shift) {
    auto& front = shift >= 0 ? later : earlier;
    auto& back = shift >= 0 ? earlier : later;
    const auto by = static_cast<std::size_t>(std::abs(shift));
    front.erase(front.begin(), front.begin() + static_cast<std::ptrdiff_t>(std::min(by, front.size())));
    back.resize(back.size() - std::min(by, back.size()));
}

}  // namespace

Delay estimate_delay(const std::vector<double>& earlier, const std::vector<double>& later, double sampling_rate_hz,
                     const DelayOptions& options) {
    assert(earlier.size() == later.size() && options.least_s < options.most_s);
    Delay delay;
    const double highest = std::min(options.to_hz, 0.8 * 0.5 * sampling_rate_hz);
    const double reach = std::max(std::abs(options.least_s), std::abs(options.most_s)),
                 duration = static_cast<double>(earlier.size()) / sampling_rate_hz;
    // Of the longest delay half the record must be left to compare.
    if (duration < 2.0 * reach || earlier.size() < 256) return delay;
    const Peak peak = whitened_peak(earlier, later, sampling_rate_hz, options, highest);
    delay.false_alarm = std::min(1.0, 2.0 * peak.tests * normal_exceeded(peak.deviations));
    delay.inverted = peak.value < 0.0;
    const long shift = std::lround(peak.delay_s * sampling_rate_hz);
    std::vector<double> a = earlier, b = later;
    shift_together(a, b, shift);
    const double window = std::min(options.window_s, static_cast<double>(a.size()) / sampling_rate_hz / 4.0);
    if (window * sampling_rate_hz < 16.0) return delay;
    const double block_hz = std::max(4.0 / window, 1.0 / std::max(0.01, std::abs(peak.delay_s)));
    const PhaseLine line = fit_phase_line(pair_spectra(a, b, sampling_rate_hz, window), delay.inverted ? -1.0 : 1.0,
                                          options, highest, block_hz);
    delay.seconds = static_cast<double>(shift) / sampling_rate_hz + line.delay_s;
    delay.standard_error_s = std::max(line.bound_s, line.scatter_s);
    delay.correlation = line.correlation;
    delay.found = delay.false_alarm < 1e-5 && delay.standard_error_s > 0.0 && line.correlation > 0.3;
    return delay;
}

}  // namespace railpem::recordings

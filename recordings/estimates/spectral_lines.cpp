#include "recordings/estimates/spectral_lines.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "recordings/estimates/confidence.hpp"
#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/estimates/fourier_transform.hpp"
#include "recordings/estimates/slepian_tapers.hpp"

namespace railpem::recordings {
namespace {

using Complex = std::complex<double>;

/// Sums over the sections, per frequency, that the F test is made of.
struct LineSums {
    double bin_hz = 0.0;
    std::vector<double> line;      ///< Σ_s |μ_s|²
    std::vector<double> residual;  ///< Σ_s Σ_k |y − μH|²
    double energy = 0.0;           ///< Σ_k H_k(0)²
    std::size_t sections = 0;
    std::size_t tapers = 0;

    double f(std::size_t k) const { return (static_cast<double>(tapers) - 1.0) * line[k] * energy / residual[k]; }
    double exceeded(std::size_t k) const {
        const double s = static_cast<double>(sections);
        return residual[k] > 0.0 ? f_exceeded(f(k), 2.0 * s, 2.0 * s * (static_cast<double>(tapers) - 1.0)) : 1.0;
    }
};

bool complete(const std::vector<double>& samples, std::size_t begin, std::size_t length) {
    return std::all_of(samples.begin() + static_cast<std::ptrdiff_t>(begin),
                       samples.begin() + static_cast<std::ptrdiff_t>(begin + length),
                       [](double x) { return std::isfinite(x); });
}

/// Tapers of the length last asked for: all channels of a record use the same.
const std::vector<std::vector<double>>& remembered_tapers(std::size_t length, const LineOptions& options) {
    thread_local std::vector<std::vector<double>> tapers;
    thread_local double half_bandwidth = 0.0;
    if (tapers.size() != static_cast<std::size_t>(options.tapers) || tapers[0].size() != length ||
        half_bandwidth != options.half_bandwidth) {
        tapers = slepian_tapers(length, options.half_bandwidth, static_cast<std::size_t>(options.tapers));
        half_bandwidth = options.half_bandwidth;
    }
    return tapers;
}

LineSums line_sums(const std::vector<double>& all, double rate, const LineOptions& options) {
    const auto length = static_cast<std::size_t>(options.section_s * rate);
    LineSums sums;
    sums.tapers = static_cast<std::size_t>(options.tapers);
    if (length < 16 || all.size() < length) return sums;
    const std::vector<double> samples = without_trend(all);
    const auto& tapers = remembered_tapers(length, options);
    const FourierTransform transform(fast_length(length * static_cast<std::size_t>(options.oversampling)));
    const std::size_t bins = transform.bins();
    sums.bin_hz = rate / static_cast<double>(transform.length());
    sums.line.assign(bins, 0.0);
    sums.residual.assign(bins, 0.0);
    std::vector<double> h(sums.tapers);
    for (std::size_t k = 0; k < sums.tapers; ++k)
        h[k] = k % 2 == 0 ? std::accumulate(tapers[k].begin(), tapers[k].end(), 0.0) : 0.0;
    sums.energy = std::inner_product(h.begin(), h.end(), h.begin(), 0.0);
    std::vector<double> work(transform.length());
    std::vector<std::vector<Complex>> y(sums.tapers, std::vector<Complex>(bins));
    for (std::size_t begin = 0; begin + length <= samples.size(); begin += length) {
        if (!complete(samples, begin, length)) continue;
        ++sums.sections;
        for (std::size_t k = 0; k < sums.tapers; ++k) {
            std::fill(work.begin(), work.end(), 0.0);
            for (std::size_t n = 0; n < length; ++n) work[n] = tapers[k][n] * samples[begin + n];
            transform.forward(work.data(), y[k].data());
        }
        for (std::size_t i = 0; i < bins; ++i) {
            Complex mean = 0.0;
            for (std::size_t k = 0; k < sums.tapers; ++k) mean += y[k][i] * h[k];
            mean /= sums.energy;
            sums.line[i] += std::norm(mean);
            for (std::size_t k = 0; k < sums.tapers; ++k) sums.residual[i] += std::norm(y[k][i] - mean * h[k]);
        }
    }
    return sums;
}

/// E|y|² of the broadband part beside a line: the median between 1.25 and 2.5 half-bandwidths away on both sides, where
/// the tapers keep the line out. At the line itself what is left of it would count as noise.
double broadband_beside(const LineSums& sums, std::size_t peak, const LineOptions& options) {
    const double half = options.half_bandwidth / options.section_s / sums.bin_hz;
    std::vector<double> values;
    const auto from = static_cast<std::size_t>(1.25 * half), to = static_cast<std::size_t>(2.5 * half);
    for (std::size_t d = from; d <= to; ++d) {
        if (peak >= d + 1) values.push_back(sums.residual[peak - d]);
        if (peak + d + 1 < sums.residual.size()) values.push_back(sums.residual[peak + d]);
    }
    if (values.empty()) values.push_back(sums.residual[peak]);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2] / (static_cast<double>(sums.sections) * (static_cast<double>(sums.tapers) - 1.0));
}

SpectralLine line_from(const LineSums& sums, std::size_t peak, double rate, const LineOptions& options) {
    const double s = static_cast<double>(sums.sections), section_s = options.section_s;
    // Parabola through the logarithms around the peak: the tapers' main lobe is nearly Gaussian there.
    double shift = 0.0, height = sums.line[peak];
    if (peak > 0 && peak + 1 < sums.line.size()) {
        const double a = std::log(sums.line[peak - 1]), b = std::log(sums.line[peak]),
                     c = std::log(sums.line[peak + 1]);
        const double curvature = a - 2.0 * b + c;
        if (curvature < 0.0 && b >= a && b >= c) {
            shift = std::clamp(0.5 * (a - c) / curvature, -0.5, 0.5);
            height = std::exp(b - 0.25 * (a - c) * shift);
        }
    }
    const double noise = broadband_beside(sums, peak, options);
    SpectralLine line;
    line.frequency_hz = (static_cast<double>(peak) + shift) * sums.bin_hz;
    line.background = 2.0 * noise / rate;
    // |μ|² = A²/4 for a sinusoid of amplitude A, whose mean square is A²/2; noise adds E|y|²/ΣH² to |μ|².
    line.mean_square = std::max(0.0, 2.0 * (height / s - noise / sums.energy));
    const double ratio = line.mean_square > 0.0 ? line.mean_square / (line.background / section_s) : 0.0;
    // Cramér–Rao bound for a sinusoid in white noise, one section: √6/(2π T √(2·ratio/2)).
    line.frequency_error_hz =
        ratio > 0.0 ? std::sqrt(6.0 / (ratio * s)) / (2.0 * std::numbers::pi * section_s) : sums.bin_hz;
    return line;
}

}  // namespace

std::vector<SpectralLine> find_lines(const std::vector<double>& samples, double sampling_rate_hz,
                                     const LineOptions& options) {
    const LineSums sums = line_sums(samples, sampling_rate_hz, options);
    std::vector<SpectralLine> lines;
    if (sums.sections == 0) return lines;
    const double highest = std::min(options.to_hz, 0.95 * 0.5 * sampling_rate_hz);
    const auto first = static_cast<std::size_t>(std::ceil(options.from_hz / sums.bin_hz));
    const auto last = std::min(sums.line.size(), static_cast<std::size_t>(highest / sums.bin_hz) + 1);
    // As many independent tests as there are bins without the finer grid, twice that to be on the safe side.
    const double tests = 2.0 * (highest - options.from_hz) * options.section_s;
    const auto reach = static_cast<std::size_t>(std::ceil(options.half_bandwidth / options.section_s / sums.bin_hz));
    for (std::size_t i = first; i < last; ++i) {
        const std::size_t from = i > reach ? i - reach : 0, to = std::min(sums.line.size(), i + reach + 1);
        const double f = sums.f(i);
        if (!(f > 4.0)) continue;  // far from significance for any number of sections
        bool largest = true;
        for (std::size_t j = from; j < to && largest; ++j) largest = sums.f(j) <= f;
        const double exceeded = largest ? sums.exceeded(i) : 1.0;
        if (!largest || exceeded * tests > options.false_alarm) continue;
        // The F value peaks where the line is; the amplitude's maximum may be one bin beside it.
        std::size_t peak = i;
        while (peak + 1 < sums.line.size() && peak < i + 2 && sums.line[peak + 1] > sums.line[peak]) ++peak;
        while (peak > 0 && peak + 2 > i && sums.line[peak - 1] > sums.line[peak]) --peak;
        SpectralLine line = line_from(sums, peak, sampling_rate_hz, options);
        line.false_alarm = std::min(1.0, exceeded * tests);
        lines.push_back(line);
    }
    return lines;
}

SpectralLine line_at(const std::vector<double>& samples, double sampling_rate_hz, double frequency_hz,
                     const LineOptions& options) {
    const LineSums sums = line_sums(samples, sampling_rate_hz, options);
    if (sums.sections == 0 || frequency_hz >= 0.5 * sampling_rate_hz) return {};
    const auto bin = static_cast<std::size_t>(std::lround(frequency_hz / sums.bin_hz));
    SpectralLine line = line_from(sums, bin, sampling_rate_hz, options);
    line.false_alarm = sums.exceeded(bin);
    return line;
}

std::vector<double> without_lines(const std::vector<double>& samples, double sampling_rate_hz,
                                  const std::vector<SpectralLine>& lines, double section_s) {
    std::vector<double> result(samples);
    const auto length = static_cast<std::size_t>(section_s * sampling_rate_hz);
    if (lines.empty() || length < 16 || samples.size() < length) return result;
    const auto columns = static_cast<Eigen::Index>(2 * lines.size());
    const std::size_t hop = length / 2;
    // Hann sections half overlapped add up to one: every sample gets a smooth mixture of two fits.
    const std::vector<double> weight = window_samples(Window::hann, length);
    for (std::ptrdiff_t start = -static_cast<std::ptrdiff_t>(hop); start < static_cast<std::ptrdiff_t>(samples.size());
         start += static_cast<std::ptrdiff_t>(hop)) {
        // Near the ends the fit is made on the last whole section inside the record.
        const auto begin = static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(start, 0, static_cast<std::ptrdiff_t>(samples.size() - length)));
        if (!complete(samples, begin, length)) continue;
        Eigen::MatrixXd basis(static_cast<Eigen::Index>(length), columns);
        Eigen::VectorXd values(static_cast<Eigen::Index>(length)), taper(static_cast<Eigen::Index>(length));
        for (std::size_t n = 0; n < length; ++n) {
            const auto row = static_cast<Eigen::Index>(n);
            values[row] = samples[begin + n];
            taper[row] = std::sqrt(weight[n]);
            for (std::size_t l = 0; l < lines.size(); ++l) {
                const double angle =
                    2.0 * std::numbers::pi * lines[l].frequency_hz * static_cast<double>(n) / sampling_rate_hz;
                basis(row, static_cast<Eigen::Index>(2 * l)) = std::cos(angle);
                basis(row, static_cast<Eigen::Index>(2 * l + 1)) = std::sin(angle);
            }
        }
        const Eigen::MatrixXd weighted = taper.asDiagonal() * basis;
        const Eigen::VectorXd coefficients =
            (weighted.transpose() * weighted).ldlt().solve(weighted.transpose() * taper.cwiseProduct(values));
        const Eigen::VectorXd fitted = basis * coefficients;
        for (std::size_t n = 0; n < length; ++n) {
            const std::ptrdiff_t in_section = static_cast<std::ptrdiff_t>(begin + n) - start;
            if (in_section < 0 || in_section >= static_cast<std::ptrdiff_t>(length)) continue;
            result[begin + n] -= weight[static_cast<std::size_t>(in_section)] * fitted[static_cast<Eigen::Index>(n)];
        }
    }
    return result;
}

}  // namespace railpem::recordings

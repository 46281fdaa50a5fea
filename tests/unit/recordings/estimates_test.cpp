#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numeric>
#include <random>

#include "parameters/parameter_error.hpp"
#include "recordings/estimates/confidence.hpp"
#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/estimates/fourier_transform.hpp"
#include "recordings/estimates/slepian_tapers.hpp"
#include "recordings/estimates/spectral_lines.hpp"
#include "synthetic_record.hpp"

namespace railpem::recordings {
namespace {

constexpr double pi = std::numbers::pi;

TimeSeries white(std::size_t samples, std::size_t channels, unsigned seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    TimeSeries series;
    series.sampling_rate_hz = 1000.0;
    for (std::size_t i = 0; i < channels; ++i) {
        series.channels.push_back({{.name = "c" + std::to_string(i)}, std::vector<double>(samples)});
        for (double& x : series.channels.back().samples) x = normal(generator);
    }
    return series;
}

TEST(FourierTransform, AgreesWithTheSumAndInverts) {
    for (const std::size_t length : {4U, 6U, 10U, 30U, 64U, 90U}) {
        const TimeSeries series = white(length, 1, static_cast<unsigned>(length));
        const auto& x = series.channels[0].samples;
        const FourierTransform transform(length);
        std::vector<std::complex<double>> spectrum(transform.bins());
        transform.forward(x.data(), spectrum.data());
        for (std::size_t k = 0; k < spectrum.size(); ++k) {
            std::complex<double> sum = 0.0;
            for (std::size_t n = 0; n < length; ++n)
                sum += x[n] * std::polar(1.0, -2.0 * pi * static_cast<double>(k * n) / static_cast<double>(length));
            EXPECT_LT(std::abs(sum - spectrum[k]), 1e-12 * static_cast<double>(length));  // rounding of the plain sum
        }
        std::vector<double> back(length);
        transform.inverse(spectrum.data(), back.data());
        for (std::size_t n = 0; n < length; ++n) EXPECT_NEAR(back[n], x[n], 1e-13);
    }
}

TEST(CrossSpectra, KeepTheMeanSquareOfARectangularWindow) {
    // Parseval: without overlap and with a rectangular window the integral of the estimate is the mean square, to
    // rounding.
    const TimeSeries series = white(8000, 2, 3);
    const CrossSpectra spectra = estimate_cross_spectra(
        series, {.window = Window::rectangular, .window_s = 1.0, .overlap = 0.0, .remove_trend = false});
    for (std::size_t i = 0; i < 2; ++i) {
        double power = 0.0;
        for (std::size_t k = 0; k < spectra.bins(); ++k) power += spectra.psd(k, i);
        power *= spectra.kernel().bin_hz();
        const auto& x = series.channels[i].samples;
        EXPECT_NEAR(power, std::inner_product(x.begin(), x.end(), x.begin(), 0.0) / 8000.0, 1e-12);
    }
}

TEST(CrossSpectra, AreHermitianPositiveAndCarryTheStatedSign) {
    TimeSeries series = white(20000, 1, 5);
    Channel later = series.channels[0];
    std::rotate(later.samples.begin(), later.samples.end() - 3, later.samples.end());  // 3 ms later
    series.channels.push_back(later);
    const CrossSpectra spectra = estimate_cross_spectra(series, {.window_s = 1.0});
    for (std::size_t k = 1; k < 400; ++k) {
        const Eigen::MatrixXcd s = spectra.matrix(k);
        EXPECT_EQ((s - s.adjoint()).norm(), 0.0);
        EXPECT_GE(s.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), -1e-15);
        // Channel 1 is later: S_10 = X_1 X_0* has the phase −ωτ.
        const double phase =
            std::remainder(std::arg(spectra.at(k, 1, 0)) + 2.0 * pi * spectra.frequency_hz[k] * 0.003, 2.0 * pi);
        EXPECT_NEAR(phase, 0.0, 0.2);
    }
}

TEST(CrossSpectra, IntervalsOfTheSpectrumCoverNineOutOfTen) {
    // 1000 records of white noise, one-sided density 2/f_s. The share of bins inside the stated interval, mean over
    // records.
    const double truth = 2.0 / 1000.0;
    double covered = 0.0, bins = 0.0, mean = 0.0;
    Interval interval;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const CrossSpectra spectra =
            estimate_cross_spectra(white(8000, 1, 10000 + seed), {.window_s = 0.5, .remove_trend = false});
        interval = spectrum_interval(spectra.averages);
        for (std::size_t k = 4; k < spectra.bins() - 4; ++k, bins += 1.0) {
            const double estimate = spectra.psd(k, 0);
            mean += estimate;
            covered += estimate * interval.low <= truth && truth <= estimate * interval.high ? 1.0 : 0.0;
        }
    }
    EXPECT_GE(covered / bins, 0.88);
    EXPECT_LE(covered / bins, 0.92);
    // Unbiased: the mean of 242 000 values with about 30 averages each has a standard error of 4e-4, correlated bins
    // included.
    EXPECT_NEAR(mean / bins / truth, 1.0, 0.0016);
    RecordProperty("coverage", std::to_string(covered / bins));
}

TEST(CrossSpectra, ScatterAsTheClosedFormOfTheirAveragesSays) {
    // Calibration on nulls: variance of one bin, of neighbours, and of a band, for three overlaps.
    for (const double overlap : {0.0, 0.5, 0.75}) {
        std::vector<double> one, next, band;
        Segmentation segments;
        const std::size_t first = 40, count = 30;
        for (unsigned seed = 0; seed < 1500; ++seed) {
            const CrossSpectra spectra = estimate_cross_spectra(
                white(2500, 1, 90000 + seed), {.window_s = 0.25, .overlap = overlap, .remove_trend = false});
            segments = spectra.segments;
            one.push_back(500.0 * spectra.psd(first, 0));
            next.push_back(500.0 * spectra.psd(first + 1, 0));
            double sum = 0.0;
            for (std::size_t k = first; k < first + count; ++k) sum += 500.0 * spectra.psd(k, 0);
            band.push_back(sum / static_cast<double>(count));
        }
        const auto covariance = [](const std::vector<double>& a, const std::vector<double>& b) {
            const double ma = std::accumulate(a.begin(), a.end(), 0.0) / static_cast<double>(a.size()),
                         mb = std::accumulate(b.begin(), b.end(), 0.0) / static_cast<double>(b.size());
            double sum = 0.0;
            for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - ma) * (b[i] - mb);
            return sum / static_cast<double>(a.size() - 1);
        };
        // A variance from 1500 values has a relative standard error of √(2/1500) = 3.7 %; four of them.
        EXPECT_NEAR(covariance(one, one) * independent_averages(segments), 1.0, 0.15) << overlap;
        EXPECT_NEAR(covariance(band, band) * band_averages(segments, std::vector<double>(count, 1.0)), 1.0, 0.15)
            << overlap;
        // A covariance of two values with variance V has the standard error V/√1500 = 2.6 %.
        EXPECT_NEAR(covariance(one, next) * independent_averages(segments),
                    relative_bin_covariance(segments, 1) * independent_averages(segments), 0.11)
            << overlap;
    }
}

TEST(CrossSpectra, ExpectationIsTheModelSmoothedByTheKernel) {
    // tr(S⁻¹Ŝ)/channels over 4–175 Hz is 1 within 3 % where S is smoothed by the window's kernel; against the
    // unsmoothed cross-spectra of the same record, with delays as long as the window, it is off by orders of magnitude.
    testing::SyntheticRecord settings{.duration_s = 90.0, .seed = 11};
    const Recording recording = testing::make_record(settings);
    for (const double window_s : {1.0, 2.0, 8.0}) {
        const CrossSpectra spectra = estimate_cross_spectra(recording.series, {.window_s = window_s});
        const WindowKernel kernel = spectra.kernel();
        const int oversampling = 8;
        const std::size_t fine_count = spectra.segments.length / 2 * oversampling + 1;
        const double fine_step = kernel.bin_hz() / oversampling;
        std::vector<std::array<testing::Complex, 9>> vectors(fine_count);
        std::vector<double> level(fine_count, 0.0);
        for (std::size_t i = 1; i < fine_count; ++i) {
            vectors[i] = testing::response(static_cast<double>(i) * fine_step, settings);
            level[i] = testing::irregularity(static_cast<double>(i) * fine_step);
        }
        const double noise =
            settings.noise_rms_m_per_s2 * settings.noise_rms_m_per_s2 * 2.0 / settings.sampling_rate_hz;
        std::vector<Eigen::MatrixXcd> expected(spectra.bins(), Eigen::MatrixXcd::Zero(9, 9)), plain = expected;
        for (Eigen::Index i = 0; i < 9; ++i)
            for (Eigen::Index j = 0; j <= i; ++j) {
                std::vector<testing::Complex> fine(fine_count);
                for (std::size_t k = 0; k < fine_count; ++k)
                    fine[k] = level[k] * vectors[k][static_cast<std::size_t>(i)] *
                                  std::conj(vectors[k][static_cast<std::size_t>(j)]) +
                              (i == j ? noise : 0.0);
                const auto smooth = expected_estimate(kernel, oversampling, fine);
                for (std::size_t k = 0; k < spectra.bins(); ++k) {
                    expected[k](i, j) = smooth[k];
                    expected[k](j, i) = std::conj(smooth[k]);
                    plain[k](i, j) = fine[k * oversampling];
                    plain[k](j, i) = std::conj(fine[k * oversampling]);
                }
            }
        double whitened = 0.0, unsmoothed = 0.0, bins = 0.0;
        for (std::size_t k = 0; k < spectra.bins(); ++k) {
            if (spectra.frequency_hz[k] < 4.0 || spectra.frequency_hz[k] > 175.0) continue;
            whitened += (expected[k].ldlt().solve(spectra.matrix(k))).trace().real() / 9.0;
            unsmoothed += (plain[k].ldlt().solve(spectra.matrix(k))).trace().real() / 9.0;
            bins += 1.0;
        }
        EXPECT_NEAR(whitened / bins, 1.0, 0.03) << window_s;
        EXPECT_GT(unsmoothed / bins, window_s < 4.0 ? 100.0 : 2.0) << window_s;
        RecordProperty("whitened_trace_" + std::to_string(static_cast<int>(window_s)), std::to_string(whitened / bins));
    }
}

TEST(CrossSpectra, OfSectionsMergeToThoseOfTheWhole) {
    const TimeSeries series = white(8000, 2, 6);
    const SegmentOptions options{.window_s = 0.5, .overlap = 0.0, .remove_trend = false};
    SegmentOptions first = options, second = options;
    first.to_s = 4.0;
    second.from_s = 4.0;
    const CrossSpectra whole = estimate_cross_spectra(series, options);
    const CrossSpectra joined = merged({estimate_cross_spectra(series, first), estimate_cross_spectra(series, second)});
    ASSERT_EQ(joined.segments.count, whole.segments.count);
    EXPECT_DOUBLE_EQ(joined.averages, whole.averages);
    for (std::size_t i = 0; i < whole.matrices.size(); ++i)
        EXPECT_LT(std::abs(joined.matrices[i] - whole.matrices[i]), 1e-15);
}

TEST(CrossSpectra, LeaveOutWindowsWithMissingSamples) {
    TimeSeries series = white(8000, 2, 7);
    series.channels[1].samples[2100] = std::nan("");
    const CrossSpectra spectra = estimate_cross_spectra(series, {.window_s = 0.5});
    EXPECT_EQ(spectra.segments_skipped, 2U);
    EXPECT_EQ(spectra.segments.count, 29U);
    for (const auto& value : spectra.matrices) EXPECT_TRUE(std::isfinite(value.real()));
    std::fill(series.channels[0].samples.begin(), series.channels[0].samples.end(), std::nan(""));
    EXPECT_THROW(estimate_cross_spectra(series, {.window_s = 0.5}), parameters::ParameterError);
    EXPECT_THROW(estimate_cross_spectra(series, {.window_s = 9.0}), parameters::ParameterError);
}

TEST(CrossSpectra, DisplacementAndVelocityBecomeAcceleration) {
    // One motion measured three ways: after conversion all entries of the matrix agree.
    const double f = 20.0, omega = 2.0 * pi * f;
    TimeSeries series;
    series.sampling_rate_hz = 500.0;
    series.channels = {{{.name = "a", .quantity = ChannelQuantity::acceleration}, {}},
                       {{.name = "v", .quantity = ChannelQuantity::velocity}, {}},
                       {{.name = "d", .quantity = ChannelQuantity::displacement}, {}}};
    for (int n = 0; n < 5000; ++n) {
        const double t = n / 500.0;
        series.channels[0].samples.push_back(-omega * omega * std::sin(omega * t));
        series.channels[1].samples.push_back(omega * std::cos(omega * t));
        series.channels[2].samples.push_back(std::sin(omega * t));
    }
    const CrossSpectra spectra =
        to_acceleration(estimate_cross_spectra(series, {.window_s = 1.0, .remove_trend = false}));
    const std::complex<double> reference = spectra.at(20, 0, 0);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_LT(std::abs(spectra.at(20, i, j) / reference - 1.0), 1e-9);  // a whole number of periods: no leakage
    EXPECT_EQ(spectra.channels[2].quantity, ChannelQuantity::acceleration);
}

TEST(WindowKernel, HasUnitAreaAndMatchesTheWindowsTransform) {
    for (const Window window : {Window::rectangular, Window::hann, Window::hamming, Window::blackman_harris}) {
        const WindowKernel kernel{window, 64, 100.0};
        const auto w = window_samples(window, 64);
        double area = 0.0, energy = std::inner_product(w.begin(), w.end(), w.begin(), 0.0);
        for (int i = 0; i < 256; ++i) {
            const double nu = 100.0 * i / 256.0 - 50.0;
            std::complex<double> sum = 0.0;
            for (std::size_t n = 0; n < 64; ++n)
                sum += w[n] * std::polar(1.0, -2.0 * pi * nu * static_cast<double>(n) / 100.0);
            EXPECT_NEAR(kernel(nu), std::norm(sum) / (100.0 * energy), 1e-12);
            area += kernel(nu) * 100.0 / 256.0;
        }
        EXPECT_NEAR(area, 1.0, 1e-12);  // a trigonometric polynomial of degree 63: 256 points integrate it exactly
    }
}

TEST(WindowKernel, TwoWaysOfSmoothingAgree) {
    const WindowKernel kernel{Window::hann, 500, 500.0};
    const int oversampling = 8;
    std::vector<std::complex<double>> fine(500 / 2 * oversampling + 1);
    for (std::size_t i = 0; i < fine.size(); ++i) {
        const double f = static_cast<double>(i) / oversampling;
        fine[i] = std::polar(1.0 / (1.0 + std::pow((f - 60.0) / 5.0, 2)), -2.0 * pi * f * 0.7);
    }
    const auto direct = smoothed_by_kernel(kernel_weights(kernel, oversampling), fine, 0, 200);
    const auto exact = expected_estimate(kernel, oversampling, fine);
    for (std::size_t k = 1; k < 190; ++k)
        EXPECT_LT(std::abs(direct[k] - exact[k]), 1e-6)
            << k;  // area of the kernel beyond 8 bins: 1e-8, times the reach
}

TEST(SlepianTapers, AreOrthonormalAndConcentrated) {
    const std::size_t length = 400;
    const auto tapers = slepian_tapers(length, 4.0, 7);
    const FourierTransform transform(fast_length(16 * length));
    // Concentrations for NW = 4 (Percival & Walden 1993, table 382, to its digits for large N).
    const double leaked[] = {3e-10, 3e-8, 1.2e-6, 2.5e-5, 3.6e-4, 3.6e-3, 2.4e-2};
    for (std::size_t k = 0; k < tapers.size(); ++k) {
        for (std::size_t j = 0; j < tapers.size(); ++j)
            EXPECT_NEAR(std::inner_product(tapers[k].begin(), tapers[k].end(), tapers[j].begin(), 0.0),
                        k == j ? 1.0 : 0.0, 1e-9);
        std::vector<double> padded(transform.length(), 0.0);
        std::copy(tapers[k].begin(), tapers[k].end(), padded.begin());
        std::vector<std::complex<double>> spectrum(transform.bins());
        transform.forward(padded.data(), spectrum.data());
        double inside = 0.0, all = 0.0;
        for (std::size_t i = 0; i < spectrum.size(); ++i) {
            const double f = static_cast<double>(i) / static_cast<double>(transform.length());
            (f <= 4.0 / static_cast<double>(length) ? inside : all) += std::norm(spectrum[i]) * (i == 0 ? 0.5 : 1.0);
        }
        EXPECT_LT(all / (inside + all), 3.0 * leaked[k] + 1e-9) << k;
    }
}

TEST(SpectralLines, PowerWithinOnePercentAndNothingElse) {
    const double rate = 1000.0;
    double power_a = 0.0, power_b = 0.0;
    const int trials = 10;
    for (unsigned seed = 0; seed < trials; ++seed) {
        TimeSeries series = white(60000, 1, 400 + seed);
        auto& x = series.channels[0].samples;
        for (std::size_t n = 0; n < x.size(); ++n) {
            const double t = static_cast<double>(n) / rate;
            x[n] += 1.0 * std::sin(2.0 * pi * 37.037 * t + 0.3) + 0.5 * std::sin(2.0 * pi * 120.91 * t);
        }
        const auto lines = find_lines(x, rate);
        ASSERT_EQ(lines.size(), 2U) << seed;
        EXPECT_NEAR(lines[0].frequency_hz, 37.037, 5.0 * lines[0].frequency_error_hz + 0.002);
        EXPECT_NEAR(lines[1].frequency_hz, 120.91, 5.0 * lines[1].frequency_error_hz + 0.002);
        EXPECT_NEAR(lines[0].background, 2.0 / rate, 0.6 * 2.0 / rate);
        power_a += lines[0].mean_square / trials;
        power_b += lines[1].mean_square / trials;
        const auto rest = without_lines(x, rate, lines);
        for (const SpectralLine& line : lines)
            EXPECT_LT(line_at(rest, rate, line.frequency_hz).mean_square, 0.01 * line.mean_square);
    }
    EXPECT_NEAR(power_a / 0.5, 1.0, 0.01);
    EXPECT_NEAR(power_b / 0.125, 1.0, 0.01);
}

TEST(SpectralLines, AreNotFoundInNoise) {
    int found = 0;
    for (unsigned seed = 0; seed < 40; ++seed)
        found += static_cast<int>(find_lines(white(30000, 1, 700 + seed).channels[0].samples, 1000.0).size());
    EXPECT_LE(found, 1);  // 40 searches at 1e-4 each: 0.004 expected
}

TEST(Coherence, LimitIsExceededAsOftenAsStated) {
    double exceeded = 0.0, bins = 0.0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const CrossSpectra spectra = estimate_cross_spectra(white(8000, 2, 5000 + seed), {.window_s = 0.5});
        const double limit = coherence_limit(spectra.averages, 0.05);
        for (std::size_t k = 4; k < spectra.bins() - 4; ++k, bins += 1.0)
            exceeded += spectra.coherence(k, 0, 1) > limit ? 1.0 : 0.0;
    }
    EXPECT_NEAR(exceeded / bins, 0.05, 0.006);
}

}  // namespace
}  // namespace railpem::recordings

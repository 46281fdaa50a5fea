#include "simulate/march/sensor_chain.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "simulate/numerics/random_numbers.hpp"

namespace railpem::simulate {

namespace {

using std::numbers::pi;
using Spectrum = std::vector<std::complex<double>>;

constexpr double stopband_db = 80.0;
constexpr double pass_edge = 0.45;  // of the sampling rate
constexpr double stop_edge = 0.50;

double bessel_i0(double x) {
    double sum = 1.0;
    double term = 1.0;
    for (int k = 1; term > 1e-16 * sum; ++k) {
        term *= (0.5 * x / k) * (0.5 * x / k);
        sum += term;
    }
    return sum;
}

/// Half length in marching steps of the Kaiser filter (Kaiser's formula for length, attenuation and transition width).
int half_length(int ratio) {
    const double transition = 2.0 * pi * (stop_edge - pass_edge) / ratio;  // radians per marching step
    return static_cast<int>(std::ceil((stopband_db - 7.95) / (2.285 * transition) / 2.0));
}

std::vector<double> low_pass(int ratio) {
    const int half = half_length(ratio);
    const double beta = 0.1102 * (stopband_db - 8.7);
    const double cutoff = 0.5 * (pass_edge + stop_edge) / ratio;  // cycles per marching step
    std::vector<double> taps;
    double sum = 0.0;
    for (int i = -half; i <= half; ++i) {
        const double ideal = i == 0 ? 2.0 * cutoff : std::sin(2.0 * pi * cutoff * i) / (pi * i);
        const double place = static_cast<double>(i) / (half + 1);
        taps.push_back(ideal * bessel_i0(beta * std::sqrt(1.0 - place * place)) / bessel_i0(beta));
        sum += taps.back();
    }
    for (double& tap : taps) tap /= sum;
    return taps;
}

/// Steps after which a resonance has decayed to 1e-5.
int ring_down(const pem::SensorParameters& sensor, double rate_hz) {
    if (sensor.resonance_frequency_hz <= 0.0) return 0;
    const double decay = std::max(0.005, sensor.resonance_damping_ratio) * 2.0 * pi * sensor.resonance_frequency_hz;
    return static_cast<int>(std::ceil(std::log(1e5) / decay * rate_hz));
}

}  // namespace

ChannelFilter make_filter(const pem::SensorParameters& sensor, double sampling_rate_hz, int ratio) {
    const double rate = sampling_rate_hz * ratio;
    const std::vector<double> low = low_pass(ratio);
    const int half = half_length(ratio);
    const double delay_steps = sensor.delay_s * rate;
    const int whole = static_cast<int>(std::floor(delay_steps));
    const int ringing = ring_down(sensor, rate);
    // The fraction of a step and the resonance act on the spectrum; a margin keeps the fractional shift from wrapping
    // round.
    const int margin = delay_steps == whole ? 0 : half;
    const int length = 2 * half + 1 + ringing + 2 * margin;
    std::size_t points = 64;
    while (points < static_cast<std::size_t>(2 * length)) points *= 2;
    std::vector<double> padded(points, 0.0);
    std::copy(low.begin(), low.end(), padded.begin() + margin);
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    Spectrum spectrum;
    transform.fwd(spectrum, padded);
    for (std::size_t k = 0; k < spectrum.size(); ++k) {
        const double f = rate * static_cast<double>(k) / static_cast<double>(points);
        spectrum[k] *= sensor.gain * std::polar(1.0, -2.0 * pi * f / rate * (delay_steps - whole));
        if (sensor.resonance_frequency_hz <= 0.0) continue;
        const double ratio_f = f / sensor.resonance_frequency_hz;
        spectrum[k] /= std::complex<double>(1.0 - ratio_f * ratio_f, 2.0 * sensor.resonance_damping_ratio * ratio_f);
    }
    transform.inv(padded, spectrum, static_cast<Eigen::Index>(points));
    padded.resize(static_cast<std::size_t>(length));
    return {.taps = std::move(padded), .before = half + margin - whole};
}

void FilteredChannel::push(double value) {
    const std::size_t n = filter_.taps.size();
    kept_[next_] = value;
    kept_[next_ + n] = value;
    next_ = (next_ + 1) % n;
}

double FilteredChannel::output() const {
    const std::size_t n = filter_.taps.size();
    const double* oldest = kept_.data() + next_;
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) sum += filter_.taps[i] * oldest[n - 1 - i];
    return sum;
}

namespace {

/// Gaussian noise of the given rms whose density is `density` at f Hz, up to a factor; nothing below 0.5 Hz.
template <typename Density>
std::vector<double> gaussian_noise(double rms, std::size_t samples, double sampling_rate_hz, std::uint64_t seed,
                                   const Density& density_at) {
    std::size_t points = 64;
    while (points < samples) points *= 2;
    Spectrum spectrum(points / 2 + 1);
    double power = 0.0;
    for (std::size_t k = 1; k < spectrum.size(); ++k) {
        const double f = sampling_rate_hz * static_cast<double>(k) / static_cast<double>(points);
        if (f < 0.5) continue;
        const double density = density_at(f);
        const auto [a, b] = normal_pair_at(seed, k);
        spectrum[k] = std::sqrt(density) * std::complex<double>(a, b);
        power += 4.0 * density;  // variance of 2·Re(c·e^{iωt}), c = √density·(a + ib)
    }
    const double scale = rms / std::sqrt(power) * static_cast<double>(points);
    for (std::complex<double>& value : spectrum) value *= scale;
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::vector<double> noise;
    transform.inv(noise, spectrum, static_cast<Eigen::Index>(points));
    noise.resize(samples);
    return noise;
}

}  // namespace

std::vector<double> draw_noise(const pem::SensorParameters& sensor, std::size_t samples, double sampling_rate_hz,
                               std::uint64_t seed) {
    return gaussian_noise(sensor.noise_rms_m_per_s2, samples, sampling_rate_hz, seed, [&](double f) {
        return std::pow(f / 10.0, sensor.noise_slope_db_per_octave / (10.0 * std::log10(2.0)));
    });
}

std::vector<double> draw_pink_noise(double rms, double corner_hz, std::size_t samples, double sampling_rate_hz,
                                    std::uint64_t seed) {
    return gaussian_noise(rms, samples, sampling_rate_hz, seed, [&](double f) { return 1.0 + corner_hz / f; });
}

}  // namespace railpem::simulate

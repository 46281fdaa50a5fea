#pragma once
// Records with a known answer, made linearly in the frequency domain: a coloured irregularity met by four wheels one
// after the other, carried into bogies and body by the transfer functions of oscillators, with sensor noise. Exact
// delays of any size.

#include <array>
#include <complex>
#include <numbers>
#include <random>

#include "recordings/estimates/fourier_transform.hpp"
#include "recordings/estimates/wheelbase_speed.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings::testing {

struct SyntheticRecord {
    double duration_s = 30.0;
    double sampling_rate_hz = 1000.0;
    double speed_m_per_s = 22.2222;
    double noise_rms_m_per_s2 = 0.02;
    double neighbour_coupling = 0.15;  ///< share of the other wheel of the bogie that the rail carries over
    unsigned seed = 1;
};

inline VehicleGeometry geometry() {
    return {{10.2, 7.8, -7.8, -10.2}, {9.0, -9.0}};
}

using Complex = std::complex<double>;

/// y/x of a mass on a spring and damper whose foot moves by x.
inline Complex foot_transfer(double f, double f0, double zeta) {
    const double r = f / f0;
    return Complex(1.0, 2.0 * zeta * r) / Complex(1.0 - r * r, 2.0 * zeta * r);
}

/// Displacement spectrum of the irregularity, m²/Hz, one-sided: FRA-like fall with f³, nothing below 0.3 Hz.
inline double irregularity(double f) {
    return f < 0.3 ? 0.0 : 2e-6 / (f * f * (1.0 + std::pow(f / 2.0, 1.2)));
}

/// What wheel i sees of the irregularity under wheel j of its own bogie (i = j or its neighbour).
inline Complex wheel_transfer(double f, bool own, double coupling) {
    const Complex own_part = 1.0 / Complex(1.0 - std::pow(f / 70.0, 2), 2.0 * 0.25 * f / 70.0);
    return own ? own_part : coupling * std::pow(f / 70.0, 2) * own_part * own_part / (1.0 + std::pow(f / 70.0, 4));
}

/// Accelerations per unit displacement of irregularity source: the vector of all nine channels at f (channels as in
/// description()), with the delays of the wheels.
inline std::array<Complex, 9> response(double f, const SyntheticRecord& record) {
    const VehicleGeometry g = geometry();
    const double omega = 2.0 * std::numbers::pi * f;
    std::array<Complex, 4> input, wheel;
    for (std::size_t j = 0; j < 4; ++j)
        input[j] = std::polar(1.0, -omega * (g.wheels_m[0] - g.wheels_m[j]) / record.speed_m_per_s);
    for (std::size_t j = 0; j < 4; ++j)
        wheel[j] = wheel_transfer(f, true, record.neighbour_coupling) * input[j] +
                   wheel_transfer(f, false, record.neighbour_coupling) * input[j ^ 1];
    std::array<Complex, 9> y{};
    for (std::size_t j = 0; j < 4; ++j) y[j] = wheel[j];
    const Complex bogie = foot_transfer(f, 6.0, 0.2), body = foot_transfer(f, 1.0, 0.2);
    y[4] = 0.5 * bogie * (wheel[0] + wheel[1]);
    y[5] = 0.5 * bogie * (wheel[2] + wheel[3]);
    y[6] = body * (0.8 * y[4] + 0.2 * y[5]);
    y[7] = body * (0.2 * y[4] + 0.8 * y[5]);
    y[8] = 0.5 * (y[6] + y[7]);
    // The acquisition's anti-aliasing filter, Butterworth of twelfth order at 0.33 of the sampling rate, without its
    // phase.
    const double filter = 1.0 / std::sqrt(1.0 + std::pow(f / (0.33 * record.sampling_rate_hz), 24));
    for (Complex& value : y) value *= -omega * omega * filter;
    return y;
}

inline RecordingDescription description(const SyntheticRecord& record) {
    RecordingDescription d;
    d.data = "recording.csv";
    d.sampling_rate_hz = record.sampling_rate_hz;
    d.speed_m_per_s = record.speed_m_per_s;
    const auto add = [&](std::string name, Location location, int index, double position) {
        ChannelDescription channel;
        channel.name = std::move(name);
        channel.unit = "m/s^2";
        channel.location = location;
        channel.index = index;
        channel.position_m = position;
        d.channels.push_back(channel);
    };
    for (int i = 1; i <= 4; ++i) add("axlebox_" + std::to_string(i), Location::wheel, i, 0.0);
    for (int i = 1; i <= 2; ++i) add("bogie_" + std::to_string(i), Location::bogie, i, 0.0);
    add("body_front", Location::body, 0, 9.0);
    add("body_rear", Location::body, 0, -9.0);
    add("body_centre", Location::body, 0, 0.0);
    return d;
}

/// A record of the description. Periodic in its length, which no window shorter than it can see.
inline Recording make_record(const SyntheticRecord& record) {
    const std::size_t length = fast_length(static_cast<std::size_t>(record.duration_s * record.sampling_rate_hz));
    const FourierTransform transform(length);
    std::mt19937_64 generator(record.seed);
    std::normal_distribution<double> normal;
    const double df = record.sampling_rate_hz / static_cast<double>(length);
    std::array<std::vector<Complex>, 9> spectra;
    for (auto& spectrum : spectra) spectrum.resize(transform.bins());
    for (std::size_t k = 1; k + 1 < transform.bins(); ++k) {
        const double f = static_cast<double>(k) * df;
        // E|X_k|² = S f_s N/2 for a one-sided density S.
        const double scale = std::sqrt(irregularity(f) * record.sampling_rate_hz * static_cast<double>(length) / 4.0);
        const Complex e = scale * Complex(normal(generator), normal(generator));
        const auto y = response(f, record);
        for (std::size_t i = 0; i < 9; ++i) spectra[i][k] = y[i] * e;
    }
    Recording recording;
    recording.description = description(record);
    recording.file = "synthetic";
    recording.series.sampling_rate_hz = record.sampling_rate_hz;
    for (std::size_t i = 0; i < 9; ++i) {
        Channel channel{recording.description.channels[i], std::vector<double>(length)};
        transform.inverse(spectra[i].data(), channel.samples.data());
        for (double& sample : channel.samples) sample += record.noise_rms_m_per_s2 * normal(generator);
        recording.series.channels.push_back(std::move(channel));
    }
    return recording;
}

}  // namespace railpem::recordings::testing

#pragma once
// One sound record and what the tests of its faults ask of it.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recordings/estimates/fourier_transform.hpp"
#include "recordings/inspection/inspect.hpp"
#include "synthetic_record.hpp"

namespace railpem::recordings::testing {

inline InspectionContext context() {
    InspectionContext c;
    c.geometry = geometry();
    c.wheel_radius_m = 0.42;
    c.sleeper_spacing_m = 0.6;
    return c;
}

inline const SyntheticRecord& settings() {
    static const SyntheticRecord s{.duration_s = 24.0, .sampling_rate_hz = 500.0, .seed = 3};
    return s;
}

/// A sound record, made once.
inline const Recording& sound() {
    static const Recording recording = make_record(settings());
    return recording;
}

inline std::vector<double>& samples(Recording& recording, const std::string& name) {
    for (Channel& channel : recording.series.channels)
        if (channel.description.name == name) return channel.samples;
    throw std::logic_error(name);
}

inline double rms(const std::vector<double>& x) {
    double sum = 0.0;
    for (const double v : x) sum += v * v;
    return std::sqrt(sum / static_cast<double>(x.size()));
}

inline std::vector<Fault> found(const Recording& recording, FaultKind kind, const InspectionContext& c = context()) {
    std::vector<Fault> result;
    for (const Fault& fault : inspect(recording, c).faults)
        if (fault.kind == kind) result.push_back(fault);
    return result;
}

inline void expect_only(const std::vector<Fault>& faults, const std::string& channel) {
    ASSERT_EQ(faults.size(), 1U) << (faults.size() > 1 ? faults[1].says : "");
    ASSERT_FALSE(faults[0].channels.empty());
    EXPECT_EQ(faults[0].channels[0], channel) << faults[0].says;
    EXPECT_FALSE(faults[0].says.empty());
}

/// The samples delayed by any time, periodic in the record.
inline void delay(std::vector<double>& x, double seconds, double rate) {
    const FourierTransform transform(x.size());
    std::vector<std::complex<double>> spectrum(transform.bins());
    transform.forward(x.data(), spectrum.data());
    for (std::size_t k = 0; k < spectrum.size(); ++k)
        spectrum[k] *= std::polar(
            1.0, -2.0 * std::numbers::pi * static_cast<double>(k) * rate / static_cast<double>(x.size()) * seconds);
    transform.inverse(spectrum.data(), x.data());
}

}  // namespace railpem::recordings::testing

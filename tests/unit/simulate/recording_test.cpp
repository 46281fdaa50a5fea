#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <sstream>

#include "parameters/parameter_error.hpp"
#include "simulate/march/profile.hpp"
#include "simulate/march/sensor_chain.hpp"
#include "simulate/march/simulate.hpp"
#include "spectra/irregularity_spectrum.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::simulate {
namespace {

using std::numbers::pi;

ProfileRequest request_of(double from, double to) {
    ProfileRequest request;
    request.from_m = from;
    request.to_m = to;
    request.shortest_wavelength_m = 0.1;
    return request;
}

TEST(Profile, VarianceIsTheIntegralOfTheSpectrum) {
    const auto c = tests::paper_case(1);
    double expected = 0.0;
    for (int k = 1; k <= 20000; ++k) expected += spectra::irregularity_psd_m3(c.irregularity, k / 2000.0) / 2000.0;
    double measured = 0.0;
    constexpr int draws = 40;
    for (int seed = 0; seed < draws; ++seed) {
        ProfileRequest request = request_of(0.0, 2000.0);
        request.seed = static_cast<std::uint64_t>(seed) + 1;
        const double rms = profile_rms(draw_profile(c.irregularity, request), 0.0, 2000.0);
        measured += rms * rms / draws;
    }
    // The longest waves carry the variance: about 20 lines near 0.01 cycles/m, so 1/√(20·40) = 3.5 % standard error;
    // three.
    EXPECT_NEAR(measured / expected, 1.0, 0.11);
}

TEST(Profile, SameSeedAndLengthAreTheSameLineAtAnySpeed) {
    const auto c = tests::paper_case(1);
    ProfileRequest coarse = request_of(0.0, 300.0);
    coarse.length_m = 500.0;
    ProfileRequest fine = request_of(-20.0, 450.0);
    fine.length_m = 500.0;
    fine.shortest_wavelength_m = 0.05;
    const Profile a = draw_profile(c.irregularity, coarse);
    const Profile b = draw_profile(c.irregularity, fine);
    for (const double x : {0.3, 17.77, 133.4, 299.0})
        EXPECT_NEAR(a.at(x), b.at(x), 2e-3 * 5e-5) << "2e-3 of the shortest waves";
    ProfileRequest too_short = request_of(0.0, 600.0);
    too_short.length_m = 500.0;
    EXPECT_THROW(draw_profile(c.irregularity, too_short), parameters::ParameterError);
    ProfileRequest other = coarse;
    other.seed = 2;
    EXPECT_GT(std::abs(draw_profile(c.irregularity, other).at(17.77) - a.at(17.77)), 1e-6);
}

TEST(Profile, JointsAreRaisedCosines) {
    spectra::IrregularityParameters irregularity;
    irregularity.bands = {{.family = spectra::Family::power_law,
                           .shortest_wavelength_m = 0.1,
                           .longest_wavelength_m = 1.0,
                           .coefficient_m3 = 1e-30,
                           .exponent = 3.0}};
    irregularity.joints = {{.spacing_m = 25.0, .depth_m = 1e-3, .length_m = 0.8}};
    ProfileRequest request = request_of(0.0, 100.0);
    request.shortest_wavelength_m = 0.02;
    const Profile profile = draw_profile(irregularity, request);
    double lowest = 1.0;
    double at = 0.0;
    double highest = -1.0;
    for (double x = 0.0; x < 25.0; x += 1e-3) {
        if (profile.at(x) < lowest) lowest = profile.at(at = x);
        highest = std::max(highest, profile.at(x));
    }
    EXPECT_NEAR(highest - lowest, 1e-3, 1e-6);
    EXPECT_NEAR(profile.at(at + 25.0), lowest, 1e-7);
    EXPECT_NEAR(profile.at(at + 0.2) - highest, -0.5e-3, 2e-5) << "half depth at a quarter length";
}

/// Middles of the dips of 12 m on a line from −31 m of `length` m: where the height is lowest within 2 m of itself.
std::vector<double> middles_of_dips(double length) {
    spectra::IrregularityParameters irregularity;
    irregularity.bands = {{.family = spectra::Family::power_law,
                           .shortest_wavelength_m = 0.1,
                           .longest_wavelength_m = 1.0,
                           .coefficient_m3 = 1e-30,
                           .exponent = 3.0}};
    irregularity.joints = {{.spacing_m = 12.0, .depth_m = 1e-3, .length_m = 0.8}};
    const Profile profile = draw_profile(irregularity, request_of(-31.0, -31.0 + length));
    std::vector<double> middles;
    for (double x = -29.0; x < length - 34.0; x += 0.01) {
        const double here = profile.at(x);
        bool lowest = here < profile.at(x - 2.0) - 0.5e-3;
        for (double other = x - 0.4; lowest && other < x + 0.4; other += 0.01)
            lowest = profile.at(other) >= here - 1e-12;
        if (lowest && (middles.empty() || x > middles.back() + 1.0)) middles.push_back(x);
    }
    return middles;
}

// Whatever the length of the line: the comb that tells joints is as sharp as their distances are equal. Looked for in
// steps of 0.01 m.
TEST(Profile, JointsKeepTheirDistanceOnALineOfAnyLength) {
    for (const double length : {500.0, 507.3, 1337.7}) {
        const std::vector<double> middles = middles_of_dips(length);
        ASSERT_GT(middles.size(), static_cast<std::size_t>(length / 12.0) - 7);
        for (std::size_t i = 1; i < middles.size(); ++i)
            EXPECT_NEAR(middles[i] - middles[i - 1], 12.0, 0.021) << length << " m, dip " << i;
        EXPECT_NEAR(middles.back() - middles.front(), 12.0 * static_cast<double>(middles.size() - 1), 0.021);
    }
}

TEST(Profile, PatchAveragesOverItsLength) {
    MeasuredProfile wave;
    for (double x = -1.0; x < 11.0; x += 1e-3) {
        wave.position_m.push_back(x);
        wave.height_m.push_back(1e-4 * std::sin(2.0 * pi * x / 0.05));
    }
    ProfileRequest request = request_of(0.0, 10.0);
    request.shortest_wavelength_m = 0.02;
    request.patch_half_length_m = 0.008;
    const double kept = profile_rms(resample_profile(wave, request), 1.0, 9.0) * std::sqrt(2.0) / 1e-4;
    const double argument = 2.0 * pi * 0.008 / 0.05;
    EXPECT_NEAR(kept, std::sin(argument) / argument, 3e-3);  // nine samples over the patch
    EXPECT_THROW(resample_profile(wave, request_of(0.0, 12.0)), parameters::ParameterError);
}

/// Response of the filter, as the sampler sees it, at a frequency.
std::complex<double> response(const ChannelFilter& filter, double frequency_hz, double rate_hz) {
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < filter.taps.size(); ++i)
        sum += filter.taps[i] *
               std::polar(1.0, 2.0 * pi * frequency_hz / rate_hz * (filter.before - static_cast<double>(i)));
    return sum;
}

TEST(SensorChain, FlatToTheEdgeAndNothingBeyondNyquist) {
    for (const int ratio : {2, 4, 5}) {
        const ChannelFilter filter = make_filter({.channel = "bogie_1"}, 1000.0, ratio);
        for (const double f : {0.0, 30.0, 200.0, 445.0})
            EXPECT_LT(std::abs(response(filter, f, 1000.0 * ratio) - 1.0), 2e-4) << f;
        for (const double f : {500.0, 700.0, 990.0})
            EXPECT_LT(std::abs(response(filter, f, 1000.0 * ratio)), 2e-4) << f;
    }
}

TEST(SensorChain, GainDelayAndResonance) {
    const pem::SensorParameters sensor{.channel = "axlebox_1",
                                       .gain = -1.1,
                                       .resonance_frequency_hz = 150.0,
                                       .resonance_damping_ratio = 0.05,
                                       .delay_s = 0.01234};
    const ChannelFilter filter = make_filter(sensor, 1000.0, 5);
    for (const double f : {1.0, 60.0, 145.0, 300.0}) {
        const double ratio = f / 150.0;
        const std::complex<double> expected =
            -1.1 * std::polar(1.0, -2.0 * pi * f * 0.01234) / std::complex<double>(1.0 - ratio * ratio, 0.1 * ratio);
        EXPECT_LT(std::abs(response(filter, f, 5000.0) / expected - 1.0), 2e-3) << f;
    }
}

TEST(SensorChain, NoiseHasItsRmsAndSlope) {
    const pem::SensorParameters sensor{
        .channel = "body_front", .noise_rms_m_per_s2 = 0.3, .noise_slope_db_per_octave = -3.0};
    const std::vector<double> noise = draw_noise(sensor, 1 << 17, 1000.0, 11);
    double power = 0.0;
    double difference = 0.0;
    for (std::size_t i = 1; i < noise.size(); ++i) {
        power += noise[i] * noise[i] / static_cast<double>(noise.size());
        difference += (noise[i] - noise[i - 1]) * (noise[i] - noise[i - 1]) / static_cast<double>(noise.size());
    }
    // 1/f noise between 0.5 and 500 Hz: half the power lies in the lowest decade (about 600 lines), so 4 % standard
    // error.
    EXPECT_NEAR(power, 0.09, 0.09 * 0.12);
    // Differencing weighs by 4·sin²(πf/fs); for S ∝ 1/f: ∫(4·sin²)/f df/∫df/f = 0.4772 between 0.5 and 500 Hz.
    double weighed = 0.0;
    double whole = 0.0;
    for (double f = 0.5; f < 500.0; f += 0.01) {
        weighed += 4.0 * std::sin(pi * f / 1000.0) * std::sin(pi * f / 1000.0) / f;
        whole += 1.0 / f;
    }
    EXPECT_NEAR(difference / power / (weighed / whole), 1.0, 0.12);
}

TEST(SensorChain, ChannelKeepsTheLastSamples) {
    ChannelFilter filter{.taps = {1.0, 10.0, 100.0}, .before = 0};
    FilteredChannel channel(filter);
    for (const double value : {1.0, 2.0, 3.0, 4.0}) channel.push(value);
    EXPECT_EQ(channel.output(), 4.0 + 30.0 + 200.0);
}

Options short_record() {
    Options options;
    options.seconds = 2.0;
    options.settling_s = 0.5;
    return options;
}

pem::CaseParameters short_case() {
    auto c = tests::paper_case(1);
    c.frequency.from_hz = 1.0;
    return c;
}

TEST(Simulate, RefusesWhatCannotBe) {
    auto options = short_record();
    options.seconds = 1.9;
    EXPECT_THROW(simulate(short_case(), options), parameters::ParameterError);
    options.seconds = 2.0;
    options.sampling_rate_hz = 399.0;  // the case asks for 200 Hz
    EXPECT_THROW(simulate(short_case(), options), parameters::ParameterError);
    auto c = short_case();
    c.sensors = {{.channel = "axlebox_5"}};
    EXPECT_THROW(simulate(c, short_record()), parameters::ParameterError);
}

TEST(Simulate, SeedsGiveIdenticalBitsAndOthersOtherRecords) {
    auto c = short_case();
    c.sensors = {{.channel = "bogie_2", .noise_rms_m_per_s2 = 0.1}};
    auto options = short_record();
    const Recording first = simulate(c, options);
    const Recording again = simulate(c, options);
    options.seed = 2;
    const Recording other = simulate(c, options);
    ASSERT_EQ(first.samples(), 2000u);
    for (std::size_t ch = 0; ch < 9; ++ch) {
        EXPECT_EQ(first.channels[ch].acceleration_m_per_s2, again.channels[ch].acceleration_m_per_s2);
        EXPECT_NE(first.channels[ch].acceleration_m_per_s2, other.channels[ch].acceleration_m_per_s2);
    }
    EXPECT_GT(first.making.profile_rms_m, 1e-5);
}

TEST(Simulate, DelayedChannelLagsByItsDelay) {
    auto c = short_case();
    c.sensors = {{.channel = "axlebox_3", .delay_s = 0.05}, {.channel = "axlebox_4", .gain = -1.0}};
    const Recording plain = simulate(short_case(), short_record());
    auto options = short_record();
    const Recording changed = simulate(c, options);
    double scale = 0.0;
    double lag = 0.0;
    double inverted = 0.0;
    for (std::size_t i = 200; i < 1900; ++i) {
        const auto& before = plain.channels[2].acceleration_m_per_s2;
        const auto& after = changed.channels[2].acceleration_m_per_s2;
        scale = std::max(scale, std::abs(before[i]));
        lag = std::max(lag, std::abs(after[i + 50] - before[i]));
        inverted = std::max(inverted, std::abs(changed.channels[3].acceleration_m_per_s2[i] +
                                               plain.channels[3].acceleration_m_per_s2[i]));
    }
    // The two runs settle for different times before the record; what is left of that after 0.2 s is small, not
    // nothing.
    EXPECT_LT(lag, 0.02 * scale);
    EXPECT_LT(inverted, 0.02 * scale);
}

TEST(Recording, WritersGiveHeaderRowsAndDescription) {
    Recording recording{
        .sampling_rate_hz = 500.0, .speed_m_per_s = 22.5, .payload_kg = 1200.0, .channels = {}, .making = {}};
    recording.channels = {
        {.name = "axlebox_2", .location = "wheel", .index = 2, .acceleration_m_per_s2 = {1.5, -0.25}},
        {.name = "body_front", .location = "body", .position_m = 9.0, .acceleration_m_per_s2 = {0.125, 3e-7}}};
    std::ostringstream csv;
    write_csv(csv, recording);
    EXPECT_EQ(csv.str(), "time_s,axlebox_2,body_front\n0,1.5,0.125\n0.002,-0.25,3e-07\n");
    const std::string text = description(recording, "recording.csv");
    const char* const wheel =
        "[[channel]]\nname = \"axlebox_2\"\ncolumn = \"axlebox_2\"\nquantity = \"acceleration\"\nunit = "
        "\"m/s^2\"\nlocation = \"wheel\"\nindex = 2\n";
    for (const char* expected : {"sampling_rate_hz = 500\n", "speed_m_per_s = 22.5\n", "payload_kg = 1200\n",
                                 "data = \"recording.csv\"\n", wheel, "location = \"body\"\nposition_m = 9\n"})
        EXPECT_NE(text.find(expected), std::string::npos) << expected;
}

}  // namespace
}  // namespace railpem::simulate

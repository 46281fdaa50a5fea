// Every imperfection of the marched world against its closed form. Tolerances are three standard errors of the
// statistic (four where many are looked at), stated where they are used.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "simulate/march/imperfect_sensors.hpp"
#include "simulate/march/line_faults.hpp"
#include "simulate/march/profile.hpp"
#include "simulate/march/sensor_chain.hpp"
#include "simulate/march/travel.hpp"
#include "simulate/numerics/smooth_noise.hpp"
#include "simulate/track/seat_variation.hpp"
#include "simulate/world_grades.hpp"
#include "spectra/irregularity_spectrum.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::simulate {
namespace {

using std::numbers::pi;
using Spectrum = std::vector<std::complex<double>>;

TEST(WorldGrades, EveryNumberLiesInItsRangeAndIdealIsAbsence) {
    const WorldParameters ideal = world_of_grade("ideal");
    EXPECT_EQ(ideal, WorldParameters{});
    const WorldParameters good = world_of_grade("good"), worn = world_of_grade("worn");
    for (const WorldKey& key : world_keys()) {
        for (const WorldParameters* world : {&ideal, &good, &worn}) {
            EXPECT_GE(world->*key.member, key.low) << key.name;
            EXPECT_LE(world->*key.member, key.high) << key.name;
        }
        EXPECT_LE(good.*key.member, worn.*key.member) << key.name << ": worn is never the better one";
        EXPECT_FALSE(key.source.empty()) << key.name;
    }
    for (const double strength :
         {ideal.speed_rms, ideal.speed_end_m_per_s, ideal.pad_scatter, ideal.pad_damping_scatter, ideal.support_scatter,
          ideal.own_irregularity_at_1_m, ideal.rough_level_db, ideal.impacts_per_km, ideal.gain_scatter,
          ideal.gain_drift, ideal.noise_rms_m_per_s2, ideal.tone_rms_m_per_s2})
        EXPECT_EQ(strength, 0.0);
}

/// Mean of products of the process with itself `lag` farther on, over `draws` seeds.
double correlation_of_noise(double length, double lag, int draws) {
    double sum = 0.0;
    for (int seed = 0; seed < draws; ++seed) {
        const auto own = static_cast<std::uint64_t>(seed);
        sum += smooth_noise_at(own, 1.37, length) * smooth_noise_at(own, 1.37 + lag, length);
    }
    return sum / draws;
}

TEST(SmoothNoise, HasUnitVarianceAndItsCorrelation) {
    constexpr int draws = 6000;
    // A product of two normal values of correlation r scatters by √(1 + r²).
    for (const double lag : {0.0, 0.5, 1.0, 2.0}) {
        const double expected = std::exp(-0.25 * pi * lag * lag);
        EXPECT_NEAR(correlation_of_noise(8.0, 8.0 * lag, draws), expected,
                    3.0 * std::sqrt((1.0 + expected * expected) / draws))
            << lag;
    }
}

TEST(SmoothNoise, IsTheSameCurveInAnyOrder) {
    std::vector<double> forth, back;
    for (int i = -40; i <= 40; ++i) forth.push_back(smooth_noise_at(5, 0.7 * i, 3.0));
    for (int i = 40; i >= -40; --i) back.push_back(smooth_noise_at(5, 0.7 * i, 3.0));
    std::reverse(back.begin(), back.end());
    EXPECT_EQ(forth, back);
}

Options wandering(double rms, std::uint64_t seed = 1) {
    Options options;
    options.seed = seed;
    options.world.speed_rms = rms;
    return options;
}

TEST(Travel, IdealIsAConstantSpeed) {
    const Travel travel = make_travel(22.2, Options{}, -5.0, 60.0);
    EXPECT_EQ(travel.distance(37.25), 22.2 * 37.25);
    EXPECT_EQ(travel.speed(37.25), 22.2);
}

TEST(Travel, DistanceIsTheIntegralOfTheSpeed) {
    Options table = wandering(0.018);
    table.speed_table = {{0.0, 20.0, 30.0, 40.0, 60.0}, {12.0, 25.0, 0.0, 0.0, 18.0}};
    Options ramp = wandering(0.007);
    ramp.world.speed_end_m_per_s = 30.0;
    ramp.speed_fluctuation = 0.01;
    for (const Options& options : {wandering(0.018), table, ramp}) {
        const Travel travel = make_travel(22.2, options, -6.0, 61.0);
        EXPECT_NEAR(travel.distance(0.0), 0.0, 1e-12);
        double sum = 0.0;
        constexpr double h = 2.5e-3;  // twenty to an interval of the curve: Simpson's rule is exact for its cubics
        for (int i = 0; i < 24000; ++i) {
            const double t = h * i;
            sum += h / 6.0 * (travel.speed(t) + 4.0 * travel.speed(t + 0.5 * h) + travel.speed(t + h));
            if (i % 1000 == 999) {
                ASSERT_NEAR(travel.distance(t + h), sum, 1e-6) << t;
            }
        }
    }
}

TEST(Travel, SpeedHasItsRmsCorrelationTimeAndAPlausibleAcceleration) {
    constexpr double v = 40.0, rms = 0.018, lag = 8.0, h = 0.5;
    constexpr int draws = 2500;
    double variance = 0.0, product = 0.0, acceleration = 0.0;
    for (int seed = 0; seed < draws; ++seed) {
        const Travel travel = make_travel(v, wandering(rms, static_cast<std::uint64_t>(seed)), 9.0, 19.0);
        const double now = travel.speed(10.0) / v - 1.0, later = travel.speed(10.0 + lag) / v - 1.0;
        variance += now * now / draws;
        product += now * later / draws;
        acceleration += std::pow((travel.speed(10.0 + h) - travel.speed(10.0)) / h, 2) / draws;
    }
    EXPECT_NEAR(variance / (rms * rms), 1.0, 3.0 * std::sqrt(2.0 / draws));
    EXPECT_NEAR(product / (rms * rms), std::exp(-0.25 * pi), 3.0 * std::sqrt(1.21 / draws));
    EXPECT_NEAR(std::sqrt(acceleration) / (v * rms * std::sqrt(0.5 * pi) / 8.0), 1.0, 3.0 * std::sqrt(0.5 / draws));
    EXPECT_LT(std::sqrt(acceleration), 0.3 / 2.5) << "0.3 m/s² is exceeded in a hundredth of the time at most";
}

TEST(Travel, RampAndTableAreWhatWasAskedFor) {
    Options ramp;
    ramp.seconds = 60.0;
    ramp.world.speed_end_m_per_s = 30.0;
    const Travel faster = make_travel(20.0, ramp, -5.0, 61.0);
    EXPECT_NEAR(faster.speed(-3.0), 20.0, 1e-12);
    EXPECT_NEAR(faster.speed(30.0), 25.0, 1e-9);
    EXPECT_NEAR(faster.speed(61.0), 30.0, 1e-12);
    EXPECT_NEAR(faster.distance(60.0), 25.0 * 60.0, 0.01);  // the corners at 0 and 60 s are rounded within 0.05 s
    EXPECT_EQ(highest_speed_m_per_s(faster), 30.0);
    Options stop;
    stop.speed_table = {{0.0, 10.0, 20.0, 30.0}, {15.0, 0.0, 0.0, 15.0}};
    const Travel stopping = make_travel(20.0, stop, -5.0, 61.0);
    EXPECT_NEAR(stopping.distance(20.0), 75.0, 0.01);
    EXPECT_EQ(stopping.distance(19.0), stopping.distance(11.0)) << "it stands";
    for (double t = -5.0; t < 40.0; t += 0.013) ASSERT_GE(stopping.speed(t), 0.0) << t;
    EXPECT_NEAR(stopping.speed(50.0), 15.0, 1e-12);
}

TEST(Travel, DoesNotDependOnWhereTheRunInBegins) {
    const Travel early = make_travel(25.0, wandering(0.018), -40.0, 90.0);
    const Travel late = make_travel(25.0, wandering(0.018), -5.0, 61.0);
    for (const double t : {-4.0, 0.0, 13.7, 60.0}) EXPECT_NEAR(early.distance(t), late.distance(t), 1e-9) << t;
}

TEST(SeatScatter, PadsScatterByThemselves) {
    const SeatScatter scatter{.seed = 3, .pad = 0.25, .pad_damping = 0.3};
    constexpr int seats = 40000;
    double mean = 0.0, log_mean = 0.0, square = 0.0, neighbours = 0.0, dashpot = 0.0, both = 0.0;
    for (int i = -seats / 2; i < seats / 2; ++i) {
        const double a = std::log(scatter.pad_factor(i)) + 0.5 * 0.0625,
                     b = std::log(scatter.pad_factor(i + 1)) + 0.5 * 0.0625;
        const double c = std::log(scatter.dashpot_factor(i)) + 0.5 * 0.09;
        mean += scatter.pad_factor(i) / seats;
        log_mean += a / seats;
        square += a * a / seats;
        neighbours += a * b / seats;
        dashpot += c * c / seats;
        both += a * c / seats;
    }
    const double error = 1.0 / std::sqrt(seats);
    EXPECT_NEAR(mean, 1.0, 3.0 * 0.25 * error);
    EXPECT_NEAR(log_mean, 0.0, 3.0 * 0.25 * error);
    EXPECT_NEAR(square / 0.0625, 1.0, 3.0 * std::numbers::sqrt2 * error);
    EXPECT_NEAR(neighbours / 0.0625, 0.0, 3.0 * error);
    EXPECT_NEAR(dashpot / 0.09, 1.0, 3.0 * std::numbers::sqrt2 * error);
    EXPECT_NEAR(both / (0.25 * 0.3), 0.0, 3.0 * error);
    EXPECT_EQ(scatter.support_factor(17), 1.0);
}

TEST(SeatScatter, SupportVariesSlowly) {
    const SeatScatter scatter{.seed = 4, .support = 0.35, .support_seats = 30.0};
    constexpr int seats = 120000;
    double square = 0.0, later = 0.0, next = 0.0;
    const auto log_of = [&](int i) { return std::log(scatter.support_factor(i)) + 0.5 * 0.35 * 0.35; };
    for (int i = 0; i < seats; i += 5) {
        square += 5.0 * log_of(i) * log_of(i) / seats;
        later += 5.0 * log_of(i) * log_of(i + 30) / seats;
        next += 5.0 * std::pow(log_of(i + 1) - log_of(i), 2) / seats;
    }
    // ∫ρ² over the line is √2 correlation lengths: 2800 independent values.
    const double error = std::sqrt(2.0 * 30.0 * std::numbers::sqrt2 / seats);
    EXPECT_NEAR(square / (0.35 * 0.35), 1.0, 3.0 * error);
    EXPECT_NEAR(later / (0.35 * 0.35), std::exp(-0.25 * pi), 3.0 * error);
    EXPECT_NEAR(std::sqrt(next) / 0.35, std::sqrt(0.5 * pi) / 30.0, 3.0 * error * std::sqrt(0.5 * pi) / 30.0);
}

TEST(SeatScatter, GroundLiesInSeriesWithThePadOfASingleLayer) {
    const SeatScatter scatter{.seed = 9, .pad = 0.2, .support = 0.3, .support_seats = 30.0, .ground_share = 0.4};
    for (const int seat : {-7, 0, 3, 1000})
        EXPECT_NEAR(1.0 / scatter.seat_factor(seat),
                    0.6 / scatter.pad_factor(seat) + 0.4 / scatter.support_factor(seat), 1e-12);
}

/// Spectrum of the heights of a periodic profile: no window, no leakage.
Spectrum lines_of(const Profile& profile) {
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    Spectrum lines;
    transform.fwd(lines, profile.height_m);
    return lines;
}

TEST(OwnShare, WheelsMeetTheSpectrumButAreCoherentByTheRest) {
    const auto c = tests::paper_case(1);
    ProfileRequest request{.from_m = 0.0, .to_m = 4000.0, .length_m = 4000.0, .shortest_wavelength_m = 0.1, .seed = 8};
    request.own = {.at_1_m = 0.05, .exponent = 1.0};
    std::array<Spectrum, 2> wheels;
    for (std::size_t wheel = 0; wheel < 2; ++wheel) {
        Profile profile = draw_profile(c.irregularity, request);
        add_own_profile(profile, c.irregularity, request, wheel);
        wheels[wheel] = lines_of(profile);
        for (std::complex<double>& line : wheels[wheel]) line /= static_cast<double>(profile.height_m.size());
    }
    for (const double middle : {0.05, 0.3, 1.0, 4.0}) {
        double first = 0.0, second = 0.0, difference = 0.0, count = 0.0, share = 0.0;
        std::complex<double> cross = 0.0;
        for (auto k = static_cast<std::size_t>(middle * 4000.0 * 0.8); static_cast<double>(k) < middle * 4000.0 * 1.25;
             ++k) {
            const double n = static_cast<double>(k) / 4000.0;
            const double weight = 2.0 * 4000.0 / spectra::irregularity_psd_m3(c.irregularity, n);  // one-sided
            first += weight * std::norm(wheels[0][k]);
            second += weight * std::norm(wheels[1][k]);
            difference += weight * std::norm(wheels[0][k] - wheels[1][k]);
            cross += weight * wheels[0][k] * std::conj(wheels[1][k]);
            share += std::min(1.0, 0.05 * n);
            count += 1.0;
        }
        share /= count;
        const double error = 1.0 / std::sqrt(count);
        EXPECT_NEAR(first / count, 1.0, 4.0 * error) << middle;
        EXPECT_NEAR(second / count, 1.0, 4.0 * error) << middle;
        // |H₁ − H₂|² has the mean 2·share·S; the share varies by ±22 % over the band, which adds 2 % to its scatter.
        EXPECT_NEAR(difference / count / (2.0 * share), 1.0, 4.1 * error) << middle;
        const double coherence = std::norm(cross) / (first * second);
        EXPECT_NEAR(coherence, std::pow(1.0 - share, 2), 4.0 * error * 2.0 * share + 0.002) << middle;
    }
}

TEST(LineFaults, DipsComeAtTheirRateAndAreRaisedCosines) {
    const WorldParameters world{.impacts_per_km = 4.0, .impact_depth_m = 5e-4, .impact_length_m = 0.5};
    const std::vector<Dip> dips = draw_dips(world, 6, -100e3, 400e3);
    EXPECT_NEAR(static_cast<double>(dips.size()), 2000.0, 3.0 * std::sqrt(2000.0));
    double depth = 0.0, alone = 0.0;
    for (std::size_t i = 1; i < dips.size(); ++i) {
        depth += dips[i].depth_m / static_cast<double>(dips.size() - 1);
        alone += dips[i].position_m - dips[i - 1].position_m > 250.0;
    }
    EXPECT_NEAR(depth, 5e-4, 3.0 * 5e-4 / std::sqrt(12.0 * 2000.0));
    EXPECT_NEAR(alone / 2000.0, std::exp(-1.0), 3.0 * std::sqrt(0.37 * 0.63 / 2000.0) + 0.02)
        << "distances are exponential";
    const std::vector<Dip> one{{.position_m = 30.0, .depth_m = 4e-4, .length_m = 0.6}};
    EXPECT_NEAR(height_of_dips(one, longest_m(one), 30.0), -4e-4, 1e-18);
    EXPECT_NEAR(height_of_dips(one, longest_m(one), 30.15), -2e-4, 1e-15)
        << "half the depth at a quarter of the length";
    EXPECT_EQ(height_of_dips(one, longest_m(one), 30.31), 0.0);
}

TEST(LineFaults, APlaceHasTheSameDipsHoweverMuchIsLookedAt) {
    const WorldParameters world{.impacts_per_km = 20.0};
    const std::vector<Dip> all = draw_dips(world, 6, -5000.0, 5000.0), some = draw_dips(world, 6, 130.0, 1234.0);
    std::size_t within = 0;
    for (const Dip& dip : all) {
        if (dip.position_m < 130.0 || dip.position_m > 1234.0) continue;
        ASSERT_LT(within, some.size());
        EXPECT_EQ(dip.position_m, some[within].position_m);
        EXPECT_EQ(dip.depth_m, some[within++].depth_m);
    }
    EXPECT_EQ(within, some.size());
    EXPECT_GT(within, 5u);
}

TEST(LineFaults, TheRoughStretchIsRougherByItsLevel) {
    Profile profile{.first_m = 0.0, .step_m = 0.1, .height_m = std::vector<double>(4000, 1.0), .periodic = true};
    roughen(profile, 100.0, 200.0, 4.0);
    EXPECT_EQ(profile.height_m[990], 1.0);
    EXPECT_EQ(profile.height_m[2010], 1.0);
    EXPECT_NEAR(20.0 * std::log10(profile.height_m[1500]), 4.0, 1e-9);
    EXPECT_NEAR(profile.height_m[1050], 0.5 * (1.0 + profile.height_m[1500]), 1e-9) << "half way through the fade";
}

TEST(ImperfectSensors, NoiseHasItsRmsAndColour) {
    constexpr double rate = 1000.0, corner = 10.0, rms = 0.02;
    constexpr int samples = 1 << 17;
    const std::vector<double> noise = draw_pink_noise(rms, corner, samples, rate, 21);
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    Spectrum lines;
    transform.fwd(lines, noise);
    const double white = rms * rms / (500.0 - 0.5 + corner * std::log(500.0 / 0.5));  // density far above the corner
    for (const double middle : {1.0, 10.0, 100.0}) {
        double sum = 0.0, count = 0.0;
        for (auto k = static_cast<std::size_t>(0.7 * middle * samples / rate);
             static_cast<double>(k) < 1.4 * middle * samples / rate; ++k) {
            const double f = static_cast<double>(k) * rate / samples;
            sum += 2.0 * std::norm(lines[k]) / (samples * rate) / (white * (1.0 + corner / f));
            count += 1.0;
        }
        EXPECT_NEAR(sum / count, 1.0, 3.0 / std::sqrt(count)) << middle;
    }
    double power = 0.0;
    for (const double value : noise) power += value * value / samples;
    EXPECT_NEAR(std::sqrt(power), rms, 0.01 * rms);  // of 65 000 lines, few of which count more than others
}

Recording silent(std::size_t samples) {
    Recording recording{.sampling_rate_hz = 1000.0, .channels = {}, .making = {}};
    for (const std::string& name : channel_names())
        recording.channels.push_back(
            {.name = name, .location = "wheel", .acceleration_m_per_s2 = std::vector<double>(samples, 1.0)});
    return recording;
}

TEST(ImperfectSensors, CalibrationScattersAndDrifts) {
    const WorldParameters world{.gain_scatter = 0.02, .gain_drift = 0.01};
    double gain = 0.0, drift = 0.0;
    constexpr int draws = 600;
    for (std::uint64_t seed = 0; seed < draws; ++seed)
        for (const ChannelDraw& draw : draw_calibration(world, 9, seed)) {
            gain += (draw.gain - 1.0) * (draw.gain - 1.0) / (9.0 * draws);
            drift += draw.drift * draw.drift / (9.0 * draws);
        }
    const double error = 3.0 * std::sqrt(0.5 / (9.0 * draws));
    EXPECT_NEAR(std::sqrt(gain) / 0.02, 1.0, error);
    EXPECT_NEAR(std::sqrt(drift) / 0.01, 1.0, error);
    Recording recording = silent(1001);
    spoil_channels(recording, world, 5);
    const ChannelDraw& draw = recording.making.draws.channels[4];
    const std::vector<double>& samples = recording.channels[4].acceleration_m_per_s2;
    EXPECT_NEAR(samples[500], draw.gain, 1e-12);
    EXPECT_NEAR(samples[1000] - samples[0], draw.gain * draw.drift, 1e-12);
}

TEST(ImperfectSensors, TheToneIsOnOneChannel) {
    Recording recording = silent(1000);
    spoil_channels(recording, {.tone_rms_m_per_s2 = 0.03, .tone_hz = 50.0}, 5);
    std::size_t touched = 0;
    for (const Channel& channel : recording.channels) {
        std::complex<double> line = 0.0;
        for (std::size_t i = 0; i < 1000; ++i)
            line +=
                channel.acceleration_m_per_s2[i] * std::polar(2.0 / 1000.0, -2.0 * pi * 0.05 * static_cast<double>(i));
        const bool own = channel.name == recording.making.draws.tone_channel;
        EXPECT_NEAR(std::abs(line), own ? 0.03 * std::numbers::sqrt2 : 0.0, 1e-12) << channel.name;
        touched += own;
    }
    EXPECT_EQ(touched, 1u);
}

}  // namespace
}  // namespace railpem::simulate

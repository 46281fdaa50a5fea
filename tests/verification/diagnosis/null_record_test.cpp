// Does the model side predict what the estimator measures? A null record of the time-domain world, the true model, no
// discrepancy floor: tr(S⁻¹Ŝ)/channels, S the expectation of the windowed estimate, averaged over the bins from 4 to
// 175 Hz. The record comes from numerics that share nothing with the model (finite elements marched in time, a moving
// vehicle, a Hertzian contact).

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "../pem/paper_case.hpp"
#include "diagnosis/expectation/expected_spectra.hpp"
#include "pem/distortion/contact_distortion.hpp"
#include "recordings/estimates/cross_spectra.hpp"
#include "simulate/march/simulate.hpp"

namespace {

using namespace railpem;

constexpr double kSpeed = 80.0 / 3.6;
constexpr double kNoise = 0.02;  // m/s²

recordings::TimeSeries with_noise(const simulate::Recording& made) {
    recordings::TimeSeries series;
    series.sampling_rate_hz = made.sampling_rate_hz;
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(0.0, kNoise);
    for (const simulate::Channel& channel : made.channels) {
        recordings::Channel copy;
        copy.description.name = channel.name;
        copy.description.index = channel.index;
        copy.description.position_m = channel.position_m;
        copy.description.location = channel.location == "wheel"   ? recordings::Location::wheel
                                    : channel.location == "bogie" ? recordings::Location::bogie
                                                                  : recordings::Location::body;
        copy.samples = channel.acceleration_m_per_s2;
        for (double& sample : copy.samples) sample += noise(random);
        series.channels.push_back(std::move(copy));
    }
    return series;
}

recordings::TimeSeries null_record(simulate::Mode mode, double seconds) {
    pem::CaseParameters parameters = tests::paper_case(1);
    parameters.running.speeds_m_per_s = {kSpeed};
    return with_noise(simulate::simulate(
        parameters, {.mode = mode, .seconds = seconds, .seed = 5, .linear_contact = mode == simulate::Mode::standing}));
}

double mean_trace(const recordings::TimeSeries& series, const pem::CaseParameters& model, double window_s,
                  double speed = kSpeed, const pem::ContactDistortion& contacts = {}) {
    const recordings::CrossSpectra measured = recordings::estimate_cross_spectra(series, {.window_s = window_s});
    const std::vector<diagnosis::ObservedChannel> channels = diagnosis::observed_channels(measured.channels, model);
    EXPECT_EQ(channels.size(), 9u);
    const std::vector<double> noise(channels.size(), kNoise * kNoise / (0.5 * series.sampling_rate_hz));
    const diagnosis::ExpectedSpectra expected = diagnosis::expected_spectra(
        model, speed, measured.kernel(), channels, noise, {.low_hz = 4.0, .high_hz = 175.0, .contacts = contacts});
    const std::vector<double> trace = diagnosis::whitened_trace(expected, measured, channels);
    const double mean = std::accumulate(trace.begin(), trace.end(), 0.0) / static_cast<double>(trace.size());
    std::printf("window %4.1f s: tr/channels = %.4f\n", window_s, mean);
    return mean;
}

TEST(NullRecord, MovingWheels) {
    const recordings::TimeSeries series = null_record(simulate::Mode::moving, 90.0);
    pem::CaseParameters model = tests::paper_case(1);
    model.solver.moving = true;
    model.sleeper_passing.amplitude_factor = 1.0;
    model.running.speed_fluctuation = 1e-5;  // the record's speed is constant
    EXPECT_NEAR(mean_trace(series, model, 1.0), 1.0, 0.03);
    EXPECT_NEAR(mean_trace(series, model, 2.0), 1.0, 0.03);
    EXPECT_LE(mean_trace(series, model, 8.0), 1.1);
    EXPECT_LE(mean_trace(series, model, 16.0), 1.25);
    // Without the convected rail and the sleepers the same comparison fails by a factor of three and more at 8 s.
    model.solver.moving = false;
    model.sleeper_passing.amplitude_factor = 0.0;
    EXPECT_GE(mean_trace(series, model, 8.0), 3.0);
}

TEST(NullRecord, StandingWheels) {
    const recordings::TimeSeries series = null_record(simulate::Mode::standing, 90.0);
    const pem::CaseParameters model = tests::paper_case(1);
    EXPECT_NEAR(mean_trace(series, model, 1.0), 1.0, 0.03);
    EXPECT_NEAR(mean_trace(series, model, 2.0), 1.0, 0.03);
    EXPECT_LE(mean_trace(series, model, 8.0), 1.1);
    EXPECT_LE(mean_trace(series, model, 16.0), 1.25);
}

// Pads on their curve under a train so fast that its load comes and goes by a fifth: what they distort is part of the
// expectation. Without pem/distortion/pad_distortion.hpp the traces with 4 s are 1.47 and 1.61, and a free fit ends
// beside the truth.
TEST(NullRecord, PadsThatStiffenUnderLoadDistort) {
    constexpr double kFast = 33.0;
    for (const double exponent : {0.0, 0.15}) {
        pem::CaseParameters model = tests::paper_case(3);
        model.running.speeds_m_per_s = {kFast};
        model.track.pads.exponent = exponent;
        model.track.pads.causal = true;
        const recordings::TimeSeries series = with_noise(simulate::simulate(model, {.mode = simulate::Mode::moving,
                                                                                    .seconds = 60.0,
                                                                                    .seed = 5,
                                                                                    .linear_contact = false,
                                                                                    .linear_pads = false}));
        model.solver.moving = true;
        model.sleeper_passing.amplitude_factor = 1.0;
        model.running.speed_fluctuation = 1e-5;
        EXPECT_NEAR(mean_trace(series, model, 1.0, kFast), 1.0, 0.03);
        EXPECT_NEAR(mean_trace(series, model, 4.0, kFast), 1.0, 0.1);
    }
}

// One fastener in twenty has a fifth of its stiffness left, drawn: the mean track by the coherent potential, what each
// wheel feels of a failed seat under itself and under its neighbour, and what failed seats scatter of the
// irregularity's forces. Measured 1.06; with the same pulse under all wheels 1.17.
TEST(NullRecord, FastenersFailedAtRandom) {
    pem::CaseParameters model = tests::paper_case(1);
    model.running.speeds_m_per_s = {kSpeed};
    model.track.failed_fasteners = {{.fraction = 0.05, .remaining_stiffness_fraction = 0.2, .seed = 4}};
    const recordings::TimeSeries series = with_noise(simulate::simulate(
        model, {.mode = simulate::Mode::moving, .seconds = 60.0, .seed = 5, .linear_contact = true}));
    model.solver.moving = true;
    model.sleeper_passing.amplitude_factor = 1.0;
    model.running.speed_fluctuation = 1e-5;
    EXPECT_NEAR(mean_trace(series, model, 4.0), 1.0, 0.08);
}

// Every eighth fastener gone: what a failed seat scatters of the irregularity's forces, to all orders. Measured 1.013
// and 1.025; to second order, and shaped like the standing load's lines, 1.018 and 1.13.
TEST(NullRecord, EveryEighthFastenerGone) {
    pem::CaseParameters model = tests::paper_case(1);
    model.running.speeds_m_per_s = {kSpeed};
    model.track.failed_fasteners = {{.every = 8, .remaining_stiffness_fraction = 0.0}};
    const recordings::TimeSeries series =
        with_noise(simulate::simulate(model, {.mode = simulate::Mode::moving, .seconds = 90.0, .seed = 5}));
    model.solver.moving = true;
    model.sleeper_passing.amplitude_factor = 1.0;
    model.running.speed_fluctuation = 1e-5;
    EXPECT_NEAR(mean_trace(series, model, 1.0), 1.0, 0.03);
    EXPECT_NEAR(mean_trace(series, model, 4.0), 1.0, 0.05);
}

// A contact stiffens under the load of every moment, and the rougher the track the more. The record is the Hertzian
// march itself, on class 6 raised by 3 dB: without the sources the trace is 1.040, with them 1.004, and 1.00 is what
// the estimator's own scatter leaves it within (other tests here). At 6 dB wheels leave the rail, and no law of the
// load alone describes that.
TEST(NullRecord, ContactsThatStiffenUnderLoadDistort) {
    constexpr double kFast = 33.0;
    pem::CaseParameters model = tests::paper_case(1);
    model.running.speeds_m_per_s = {kFast};
    model.irregularity.level_db = 3.0;
    const recordings::TimeSeries series = with_noise(simulate::simulate(
        model, {.mode = simulate::Mode::moving, .seconds = 60.0, .seed = 5, .linear_contact = false}));
    model.solver.moving = true;
    model.sleeper_passing.amplitude_factor = 1.0;
    model.running.speed_fluctuation = 1e-5;
    const auto as_believed = [](double) { return 1.0; };
    EXPECT_NEAR(mean_trace(series, model, 4.0, kFast, pem::contact_distortion(model, kFast, as_believed)), 1.0, 0.03);
    EXPECT_GE(mean_trace(series, model, 4.0, kFast), 1.03);
}

// Three times the Hertzian nonlinearity on class 6 as it is: with what all orders of it make of the forces, linearised
// about them, the march is what is expected; with Hertz alone it is not.
TEST(NullRecord, ContactsOfThreeTimesTheNonlinearityDistort) {
    constexpr double kFast = 33.0;
    pem::CaseParameters model = tests::paper_case(1);
    model.running.speeds_m_per_s = {kFast};
    model.contact.nonlinearity_factor = 3.0;
    const recordings::TimeSeries series = with_noise(simulate::simulate(
        model, {.mode = simulate::Mode::moving, .seconds = 60.0, .seed = 5, .linear_contact = false}));
    model.solver.moving = true;
    model.sleeper_passing.amplitude_factor = 1.0;
    model.running.speed_fluctuation = 1e-5;
    const auto as_believed = [](double) { return 1.0; };
    const double known = mean_trace(series, model, 4.0, kFast, pem::contact_distortion(model, kFast, as_believed));
    model.contact.nonlinearity_factor = 1.0;
    const double hertz = mean_trace(series, model, 4.0, kFast, pem::contact_distortion(model, kFast, as_believed));
    EXPECT_NEAR(known, 1.0, 0.05);
    EXPECT_GE(hertz, known + 0.05);
}

}  // namespace

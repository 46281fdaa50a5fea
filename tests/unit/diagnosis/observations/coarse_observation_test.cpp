// The recording in short windows, which blunt likelihoods are asked about.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "diagnosis/observations/observation.hpp"
#include "diagnosis/observations/observe.hpp"
#include "diagnosis/search/from_afar.hpp"
#include "tests/unit/diagnosis/scalar_recordings.hpp"

namespace railpem::diagnosis {
namespace {

/// Noise in two channels: what is asked here does not depend on what was measured.
recordings::Recording noise_recording(double seconds) {
    recordings::Recording recording;
    recording.description.speed_m_per_s = 22.0;
    recording.series.sampling_rate_hz = 1000.0;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    for (const auto& [name, location] :
         {std::pair{"axlebox_1", recordings::Location::wheel}, std::pair{"bogie_1", recordings::Location::bogie}}) {
        recordings::Channel channel{.description = {.name = name, .location = location, .index = 1}};
        for (int i = 0; i < static_cast<int>(1000.0 * seconds); ++i) channel.samples.push_back(normal(random));
        recording.series.channels.push_back(std::move(channel));
    }
    return recording;
}

Observation observed_noise(const BelievedCase& believed, const ObservationOptions& options = {}) {
    return observe(noise_recording(60.0), "noise", believed.numbers, options).front();
}

TEST(CoarseObservation, HasTheBandInFewerBins) {
    const BelievedCase believed = believed_file("cases/wei2016/case1.toml");
    const Observation fine = observed_noise(believed);
    ASSERT_TRUE(fine.coarse);
    EXPECT_DOUBLE_EQ(fine.coarse->kernel.bin_hz(), 0.5);
    EXPECT_EQ(fine.coarse->expectation.low_hz, fine.expectation.low_hz);
    EXPECT_EQ(fine.coarse->expectation.high_hz, fine.expectation.high_hz);
    EXPECT_NEAR(static_cast<double>(fine.coarse->bins()), 0.5 * static_cast<double>(fine.bins()), 2.0);
    EXPECT_GT(fine.coarse->fitted.averages, 1.8 * fine.fitted.averages);  // the same seconds
}

TEST(CoarseObservation, IsNotMadeWhereItWouldHoldTooLittle) {
    const BelievedCase believed = believed_file("cases/wei2016/case1.toml");
    EXPECT_FALSE(observed_noise(believed, {.high_hz = 10.0}).coarse);
}

/// The floor of a blunt likelihood is a tenth or, half sharp, kHalfSharpFloor of a channel's power: its grids leave
/// less than the smaller one, most of that (3.6 %) at 21.5 Hz, beside which the irregularity of the paper jumps by a
/// factor of 16; what supports make of the wheels' forces, which it leaves out, is less.
TEST(CoarseObservation, GridsLeaveLessThanTheFloor) {
    BelievedCase believed = believed_file("cases/wei2016/case1.toml");
    believed.numbers.solver.moving = true;
    const Observation coarse = *observed_noise(believed).coarse;
    ExpectationOptions fine = coarse.expectation;
    fine.transfer_step_hz = 0.0625;
    fine.rail_every = 1;
    fine.oversampling *= 3;
    fine.sharp = true;
    fine.weights = expectation_weights(coarse.kernel, fine.oversampling);
    const auto spectra = [&](const ExpectationOptions& options) {
        return expected_spectra(believed.numbers, coarse.speed_m_per_s, coarse.kernel, coarse.channels, {}, options);
    };
    const ExpectedSpectra own = spectra(coarse.expectation), exact = spectra(fine);
    ASSERT_EQ(own.values.size(), exact.values.size());
    for (std::size_t bin = 0; bin < own.bins(); ++bin)
        for (long c = 0; c < 2; ++c)
            EXPECT_NEAR(own.matrix(bin)(c, c).real() / exact.matrix(bin)(c, c).real(), 1.0, kHalfSharpFloor)
                << coarse.frequency(bin) << " Hz";
}

// Fasteners that failed pass forces on far louder than equal seats do: a blunt likelihood hears that, too.
TEST(CoarseObservation, HearsWhatDifferingSeatsPassOn) {
    const Observation coarse = *observed_noise(believed_file("cases/wei2016/case1.toml")).coarse;
    for (const bool failed : {false, true}) {
        pem::CaseParameters c = believed_file("cases/wei2016/case1.toml").numbers;
        c.solver.moving = true;
        if (failed) c.track.failed_fasteners = {{.every = 8, .remaining_stiffness_fraction = 0.1}};
        ExpectationCache own;
        expected_spectra(c, coarse.speed_m_per_s, coarse.kernel, coarse.channels, {}, coarse.expectation, nullptr,
                         Reuse::nothing, &own);
        EXPECT_EQ(own.felt.size() > 1, failed);
        for (const pem::Modulation& order : own.orders) EXPECT_EQ(order.bays, 0);
    }
}

// What screening looks at is the difference that next to no preload makes: a rail that came from elsewhere than that of
// equal seats (from its lines instead of the table, 1e-5 apart) drowned it, and preloaded pads promised nothing where
// they were all there was.
TEST(CoarseObservation, PadsThatLoadHardlyStiffensAreNextToEqualOnes) {
    const Observation coarse = *observed_noise(believed_file("cases/wei2016/case1.toml")).coarse;
    const auto spectra = [&](double strength) {
        pem::CaseParameters c = believed_file("cases/wei2016/case1.toml").numbers;
        c.solver.moving = true;
        c.track.pads.preload_strength = strength;
        return expected_spectra(c, coarse.speed_m_per_s, coarse.kernel, coarse.channels, {}, coarse.expectation);
    };
    constexpr double kProbed = 1e-6, kLinear = 0.01;  // of the difference: pads settle to 1e-10 of the load
    const ExpectedSpectra nothing = spectra(0.0), once = spectra(kProbed), twice = spectra(2.0 * kProbed);
    double size = 0.0, off = 0.0;
    for (std::size_t bin = 0; bin < nothing.bins(); ++bin)
        for (long c = 0; c < 2; ++c) {
            const double power = nothing.matrix(bin)(c, c).real(),
                         first = (once.matrix(bin)(c, c).real() - power) / power,
                         second = (twice.matrix(bin)(c, c).real() - power) / power;
            size += first * first;
            off += (second - 2.0 * first) * (second - 2.0 * first);
        }
    EXPECT_GT(size, 0.0);
    EXPECT_LT(std::sqrt(off), kLinear * std::sqrt(size));
}

TEST(CoarseObservation, IsWhatABluntLikelihoodIsAskedAbout) {
    const BelievedCase believed = believed_file("cases/wei2016/case1.toml");
    const std::vector<Observation> fine{observed_noise(believed)}, coarse = coarse_observations(fine);
    const LikelihoodContext context{.believed = &believed, .observations = &fine, .coarse = &coarse};
    EXPECT_EQ(blunted(context, 0.1).observations, &coarse);
    EXPECT_EQ(blunted(context, 0.1).least_floor, 0.1);
    EXPECT_EQ(blunted(context, 0.1).every, 2);
    const LikelihoodContext alone{.believed = &believed, .observations = &fine};
    EXPECT_EQ(blunted(alone, 0.1).observations, &fine);
    EXPECT_EQ(blunted(alone, 0.1).every, 1);
}

}  // namespace
}  // namespace railpem::diagnosis

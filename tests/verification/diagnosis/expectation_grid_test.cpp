// The expectation on its grids against finer ones, judged by what the channels say that the others do not: an axle box
// follows its neighbours so closely that 1e-5 of its power is all that is its own, and that is where a false alarm
// begins.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr double kSensorNoise = 0.02 * 0.02 / 500.0;  ///< (m/s²)²/Hz: of a good channel, 0.02 m/s² up to 500 Hz

/// What is left of a channel's power when all others are known, noise included.
double own_power(const ExpectedSpectra& expected, std::size_t bin, long channel) {
    Eigen::MatrixXcd matrix = expected.matrix(bin);
    matrix.diagonal().array() += kSensorNoise;
    return 1.0 / matrix.inverse()(channel, channel).real();
}

class ExpectationGrid : public testing::TestWithParam<double> {};

TEST_P(ExpectationGrid, IsFineEnoughForWhatAChannelSaysAlone) {
    Synthesised made = synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {GetParam()}, 60.0, nine_channels(), {});
    made.believed.numbers.solver.moving = true;
    const Observation& o = made.shapes[0];
    const pem::CaseParameters parameters = case_of(believed_trial(made.believed, made.shapes), made.believed, o);
    ExpectationOptions fine = o.expectation;
    fine.transfer_step_hz /= 8.0;
    const ExpectedSpectra own = expected_spectra(parameters, GetParam(), o.kernel, o.channels, {}, o.expectation);
    const ExpectedSpectra finer = expected_spectra(parameters, GetParam(), o.kernel, o.channels, {}, fine);
    double worst = 0.0;
    for (std::size_t bin = 0; bin < own.bins(); ++bin)
        for (long c = 0; c < 9; ++c)
            worst = std::max(worst, std::abs(own_power(own, bin, c) / own_power(finer, bin, c) - 1.0));
    // 30 averages over some 700 bins know a channel's own power to 1/√(30·10) = 6 % in a third octave of the lowest ten
    // bins; a third of that.
    EXPECT_LE(worst, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Speeds, ExpectationGrid, testing::Values(15.0, 22.2222, 33.0), [](const auto& tested) {
    return std::to_string(static_cast<int>(tested.param)) + "_m_per_s";
});

}  // namespace
}  // namespace railpem::diagnosis

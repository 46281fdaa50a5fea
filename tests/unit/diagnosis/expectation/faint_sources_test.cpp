#include "diagnosis/expectation/faint_sources.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace railpem::diagnosis {
namespace {

constexpr double kFaintBin_hz = 0.25, kFaintSpeed_m_per_s = 22.0;
const std::vector<double> kFaintWheels_m{20.4, 18.0, 2.4, 0.0};

/// Transfers that are one cubic in frequency each, which interpolation between lines follows exactly.
pem::WheelTransfers cubic_transfers(std::size_t channels) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    pem::WheelTransfers transfers{.from_hz = 0.0,
                                  .step_hz = 1.0,
                                  .lines = 40,
                                  .responses = std::vector<std::size_t>(channels),
                                  .values = std::vector<std::complex<double>>(40 * channels * 4)};
    for (std::size_t of = 0; of < channels * 4; ++of) {
        const std::complex<double> c[4]{{normal(random), normal(random)},
                                        {normal(random), normal(random)},
                                        {normal(random), normal(random)},
                                        {normal(random), normal(random)}};
        for (std::size_t line = 0; line < 40; ++line) {
            const double x = static_cast<double>(line) / 40.0;
            transfers.values[line * channels * 4 + of] = c[0] + x * (c[1] + x * (c[2] + x * c[3]));
        }
    }
    return transfers;
}

pem::DelayedSpectrum source(double level, std::array<double, 4> share) {
    return {.name = "faint", .psd_m2_per_hz = [level](double f) { return level / (1.0 + f); }, .share = share};
}

/// Of each source by itself, as Lin's pseudo-excitation has it: y = T·(share·√S·e^{−iωd/v}), yyᴴ.
Eigen::MatrixXcd one_by_one(const pem::WheelTransfers& transfers, const std::vector<pem::DelayedSpectrum>& sources,
                            double frequency_hz) {
    const long channels = static_cast<long>(transfers.responses.size());
    std::vector<std::complex<double>> at(transfers.responses.size() * 4);
    pem::interpolate(transfers, frequency_hz, at.data());
    Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(channels, channels);
    for (const pem::DelayedSpectrum& own : sources) {
        Eigen::VectorXcd y = Eigen::VectorXcd::Zero(channels);
        for (long c = 0; c < channels; ++c)
            for (std::size_t j = 0; j < 4; ++j) {
                const double angle = -2.0 * std::numbers::pi * frequency_hz * (kFaintWheels_m[0] - kFaintWheels_m[j]) /
                                     kFaintSpeed_m_per_s;
                y(c) += at[static_cast<std::size_t>(c) * 4 + j] * own.share[j] *
                        std::sqrt(own.psd_m2_per_hz(frequency_hz)) * std::polar(1.0, angle);
            }
        sum += y * y.adjoint();
    }
    return sum;
}

class FaintSources : public testing::TestWithParam<std::size_t> {};

// Channels of a full lane, less and more; added to what is there.
TEST_P(FaintSources, TogetherAreWhatEachGivesAlone) {
    const pem::WheelTransfers transfers = cubic_transfers(GetParam());
    const std::vector<pem::DelayedSpectrum> sources{
        source(1.0, {1.0, 1.0, 1.0, 1.0}), source(0.4, {1.0, -1.0, 1.0, -1.0}), source(2.0, {0.0, 0.0, 1.5, 0.0})};
    ExpectedSpectra expected{.first_bin = 20,
                             .channels = GetParam(),
                             .values = std::vector<std::complex<double>>(60 * GetParam() * GetParam(), 1.0)};
    add_as_they_are(transfers, sources, kFaintWheels_m, kFaintSpeed_m_per_s, kFaintBin_hz, expected);
    for (std::size_t bin = 0; bin < expected.bins(); ++bin) {
        const Eigen::MatrixXcd alone =
            one_by_one(transfers, sources, static_cast<double>(20 + bin) * kFaintBin_hz).array() +
            std::complex<double>(1.0);
        // delays follow from one another over 32 lines: 1e-15 of each
        EXPECT_LT((Eigen::MatrixXcd(expected.matrix(bin)) - alone).norm(), 1e-13 * alone.norm()) << bin;
        EXPECT_EQ((expected.matrix(bin) - expected.matrix(bin).adjoint()).norm(), 0.0) << bin;
    }
}

INSTANTIATE_TEST_SUITE_P(Channels, FaintSources, testing::Values(3, 4, 9));

TEST(NoFaintSources, AddNothing) {
    ExpectedSpectra expected{.first_bin = 4,
                             .channels = 3,
                             .values = std::vector<std::complex<double>>(2 * 9, std::complex<double>(0.5, 0.0))};
    const ExpectedSpectra before = expected;
    add_as_they_are(cubic_transfers(3), {}, kFaintWheels_m, kFaintSpeed_m_per_s, kFaintBin_hz, expected);
    EXPECT_EQ(expected.values, before.values);
}

}  // namespace
}  // namespace railpem::diagnosis

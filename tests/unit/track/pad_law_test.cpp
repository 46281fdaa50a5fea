#include "track/pads/pad_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/track/wei2016_track.hpp"

namespace railpem::track {
namespace {

using std::numbers::pi;

/// Kramers and Kronig for a stiffness that vanishes at rest, e^{+iωt}: K'(f) = (2f²/π) P∫ K''(u)/(u(f² − u²)) du,
/// computed from the imaginary part alone. With u = f·e^{±t} the principal value becomes a smooth integral over t.
double storage_from_loss(const PadParameters& pads, double f, double span) {
    const auto integrand = [&](double t) {
        const double above = pad_shape(pads, f * std::exp(t)).imag() / (1.0 - std::exp(2.0 * t));
        const double below = pad_shape(pads, f * std::exp(-t)).imag() / (1.0 - std::exp(-2.0 * t));
        return above + below;
    };
    const int steps = 40000;
    const double h = span / steps;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) sum += integrand((i + 0.5) * h);  // midpoint: t = 0 is never touched
    return 2.0 / pi * h * sum;
}

TEST(PadLaw, PaperLawIsARealPowerAndADashpot) {
    const PadParameters pads = wei2016_track().pads;
    EXPECT_EQ(pad_shape(pads, 4.0), 1.0);
    EXPECT_NEAR(pad_shape(pads, 64.0).real(), std::pow(16.0, 0.15), 1e-15);
    EXPECT_EQ(pad_shape(pads, 64.0).imag(), 0.0);
    EXPECT_EQ(pad_damping(pads), 7.5e4);
}

TEST(PadLaw, SpringPotHasTheLossTangentOfItsExponent) {
    PadParameters pads = wei2016_track().pads;
    pads.causal = true;
    for (const double f : {0.3, 4.0, 200.0}) {
        const std::complex<double> shape = pad_shape(pads, f);
        EXPECT_NEAR(shape.imag() / shape.real(), std::tan(0.5 * pi * 0.15), 1e-14);
        EXPECT_NEAR(shape.real(), std::pow(f / 4.0, 0.15), 1e-14 * shape.real());
    }
    EXPECT_EQ(pad_damping(pads), 7.5e4) << "the dashpot stays beside the spring-pot";
}

TEST(PadLaw, CausalLawsObeyKramersAndKronig) {
    PadParameters spring_pot = wei2016_track().pads;
    spring_pot.causal = true;
    PadParameters hysteretic = wei2016_track().pads;
    hysteretic.exponent = 0.0;
    hysteretic.loss_factor = 0.3;
    PadParameters both = spring_pot;
    both.loss_factor = 0.3;
    for (const PadParameters& pads : {spring_pot, hysteretic, both})
        for (const double f : {2.0, 57.6}) {
            // The tail beyond t decays as e^{−kt}, k ≥ 0.15: e^{−24} at t = 160. The midpoint rule leaves h²-errors of
            // 1e-6.
            EXPECT_NEAR(storage_from_loss(pads, f, 160.0) / pad_shape(pads, f).real(), 1.0, 1e-5);
        }
}

TEST(PadLaw, RealPowerLawDoesNot) {
    EXPECT_EQ(storage_from_loss(wei2016_track().pads, 57.6, 160.0), 0.0);
}

TEST(PadLaw, CausalLossReplacesTheDashpotAndConstantLossDoesNot) {
    PadParameters pads = wei2016_track().pads;
    pads.exponent = 0.0;
    pads.loss_factor = 0.25;
    const std::complex<double> at_reference = pad_shape(pads, 30.0);
    EXPECT_NEAR(at_reference.real(), 1.0, 1e-15);
    EXPECT_NEAR(at_reference.imag(), 0.25, 1e-15);
    const std::complex<double> high = pad_shape(pads, 300.0);
    EXPECT_NEAR(high.imag() / high.real(), 0.25, 1e-15);
    EXPECT_NEAR(high.real(), std::pow(10.0, 2.0 / pi * std::atan(0.25)), 1e-14);
    EXPECT_EQ(pad_damping(pads), 0.0);

    pads.loss_law = LossLaw::constant;
    EXPECT_EQ(pad_shape(pads, 300.0), std::complex<double>(1.0, 0.25));
    EXPECT_EQ(pad_damping(pads), 7.5e4);
}

TEST(PadLaw, TableReplacesExponentAndLoss) {
    PadParameters pads = wei2016_track().pads;
    pads.loss_factor = 0.5;
    pads.table_frequency_hz = {1.0, 10.0, 1000.0};
    pads.table_storage_ratio = {0.9, 1.2, 4.8};
    pads.table_loss_factor = {0.1, 0.2, 0.4};
    EXPECT_EQ(pad_damping(pads), 7.5e4);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::complex<double> shape = pad_shape(pads, pads.table_frequency_hz[i]);
        EXPECT_NEAR(shape.real(), pads.table_storage_ratio[i], 1e-14);
        EXPECT_NEAR(shape.imag(), pads.table_storage_ratio[i] * pads.table_loss_factor[i], 1e-14);
    }
    const std::complex<double> middle = pad_shape(pads, 100.0);  // half of the way on a logarithmic axis
    EXPECT_NEAR(middle.real(), 2.4, 1e-14);
    EXPECT_NEAR(middle.imag() / middle.real(), 0.3, 1e-14);
    EXPECT_EQ(pad_shape(pads, 0.1), pad_shape(pads, 1.0));
    EXPECT_EQ(pad_shape(pads, 5000.0), pad_shape(pads, 1000.0));
}

TEST(PadLaw, TableOfASpringPotIsTheSpringPot) {
    PadParameters law = wei2016_track().pads;
    law.causal = true;
    PadParameters table = law;
    for (const double f : {1.0, 30.0, 400.0}) {
        table.table_frequency_hz.push_back(f);
        table.table_storage_ratio.push_back(std::pow(f / 4.0, 0.15));
        table.table_loss_factor.push_back(std::tan(0.5 * pi * 0.15));
    }
    for (const double f : {1.5, 12.0, 77.0, 390.0})  // a power law is a straight line in log-log
        EXPECT_NEAR(std::abs(pad_shape(table, f) - pad_shape(law, f)), 0.0, 1e-14);
}

}  // namespace
}  // namespace railpem::track

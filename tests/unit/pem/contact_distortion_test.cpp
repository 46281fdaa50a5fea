// What contacts distort: the law, its orders, and the spectra of powers.

#include "pem/distortion/contact_distortion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "pem/angular_frequency.hpp"
#include "pem/contact.hpp"
#include "pem/gaussian_mean.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::pem {
namespace {

double carried(double nonlinearity, double y) {
    return nonlinearity * std::pow(y, 1.5) + (1.0 - nonlinearity) * (1.5 * y - 0.5);
}

TEST(ContactApproach, IsTheInverseOfTheLaw) {
    for (const double nonlinearity : {0.0, 0.3, 1.0, 2.0, 5.0})
        for (const double load : {0.75, 1.0, 1.2, 3.0})
            EXPECT_NEAR(carried(nonlinearity, contact_approach(nonlinearity, load)), load, 1e-12)
                << nonlinearity << ' ' << load;
    EXPECT_NEAR(contact_approach(1.0, 0.3), std::pow(0.3, 2.0 / 3.0), 1e-15);
}

// Three times the nonlinearity: 3/2·(3·√y − 2) vanishes at y = 4/9, where 5/9 of the load is carried. From there
// straight to nothing.
TEST(ContactApproach, DoesNotTurnBack) {
    EXPECT_NEAR(contact_approach(3.0, 5.0 / 9.0), 4.0 / 9.0, 1e-7);  // the root is double there
    EXPECT_NEAR(contact_approach(3.0, 0.25), 0.25 * 4.0 / 5.0, 1e-14);
    EXPECT_EQ(contact_approach(3.0, -1.0), 0.0);
}

// y = 1 + ⅔x − φ/9·x² + (3φ² + φ)/81·x³ …, the series of the law reversed: small forces have He₂ and He₃ with these
// coefficients. What is left is of the next order but one, σ².
TEST(ApproachOrders, AreThoseOfTheReversedSeries) {
    constexpr double kSmall = 1e-3;
    for (const double nonlinearity : {0.5, 1.0, 2.5}) {
        const ApproachOrders orders = approach_orders(nonlinearity, kSmall);
        EXPECT_NEAR(orders(0) / (-std::sqrt(2.0) * nonlinearity / 9.0 * kSmall * kSmall), 1.0, 1e-4) << nonlinearity;
        EXPECT_NEAR(orders(1) / (std::sqrt(6.0) * (3.0 * nonlinearity * nonlinearity + nonlinearity) / 81.0 *
                                 std::pow(kSmall, 3)),
                    1.0, 1e-3)
            << nonlinearity;
    }
}

// Squares of all orders make up the variance (Parseval). Beyond the highest lie 0.3 % of the distortion of Hertz at a
// quarter of the static load, 5 % at twice that nonlinearity and 10 % at five times, whose law has a corner there.
TEST(ApproachOrders, LeaveLittleBeyond) {
    for (const auto& [nonlinearity, most] : {std::pair(1.0, 0.004), std::pair(2.0, 0.06), std::pair(5.0, 0.12)}) {
        constexpr double kVariation = 0.25;
        const auto approach = [&](double xi) { return contact_approach(nonlinearity, 1.0 + kVariation * xi); };
        const double mean = gaussian_mean(approach),
                     slope = gaussian_mean([&](double xi) { return xi * approach(xi); });
        const double distortion =
            gaussian_mean([&](double xi) { return std::pow(approach(xi) - mean - slope * xi, 2); });
        const double kept = approach_orders(nonlinearity, kVariation).square().sum();
        std::printf("nonlinearity %g: %.4f of the distortion beyond order %d\n", nonlinearity, 1.0 - kept / distortion,
                    kHighestOrder);
        EXPECT_LE(kept, distortion * (1.0 + 1e-12));
        EXPECT_GE(kept, (1.0 - most) * distortion) << nonlinearity;
    }
}

// One wheel alone, whose response has the correlation σ²·e^{−a|τ|}: its powers have σ^{2n}·e^{−na|τ|}, a Lorentzian n
// times as broad. Lines of 1 Hz leave out the one at nothing, 2σ²/a of every correlation: 0.3 %, which the fourth power
// has some five times; 1 % lies beyond the last line.
TEST(ContrastsOfPowers, OfALorentzianAreLorentzians) {
    constexpr double kDecay = 600.0, kVariance = 2.5;
    const auto lorentzian = [](double f, double decay) {
        return 4.0 * decay / (decay * decay + kTwoPi * kTwoPi * f * f);
    };
    SquareTransfers transfers(6000);
    // wheel 1 as its irregularity says, the others not at all
    for (std::array<std::complex<double>, 16>& own : transfers) own[0] = 1.0;
    const DelayedSpectrum source{.name = "one wheel",
                                 .psd_m2_per_hz = [&](double f) { return kVariance * lorentzian(f, kDecay); }};
    const PairCorrelations correlations = pair_correlations(transfers, {source}, {10.2, 7.8, -7.8, -10.2}, 20.0, 4);
    for (int power = 2; power <= 4; ++power)
        for (const std::vector<double>& psd : contrasts_of_powers(correlations, power, kVariance))
            for (const std::size_t f : {10u, 150u, 400u})
                EXPECT_NEAR(psd[f] / (lorentzian(static_cast<double>(f), power * kDecay) / 16.0), 1.0, 0.04)
                    << power << " at " << f;
}

// Twice the nonlinearity: four times the power of the second order, which is nearly all at a twentieth of the static
// load. With the square of the contact constant, whose approach it is a share of, where the nonlinearity is another.
TEST(ContactDistortion, GrowsWithTheNonlinearity) {
    CaseParameters c = tests::paper_case(1);
    c.solver.moving = true;
    c.irregularity.level_db = -12.0;
    const ContactDistortion distortion = contact_distortion(c, 33.0, [](double) { return 1.0; });
    EXPECT_LT(distortion.force_variation, 0.06);
    const auto power = [&](double nonlinearity, double softness) {
        CaseParameters other = c;
        other.contact.nonlinearity_factor = nonlinearity;
        other.contact.constant_m_per_n23 = softness * contact_constant(c.contact, c.vehicle.wheel_radius_m);
        return distortion_sources(distortion, other).front().psd_m2_per_hz(65.0);
    };
    EXPECT_EQ(power(0.0, 1.0), power(1.0, 1.0));
    EXPECT_NEAR(power(2.0, 1.0) / power(1.0, 1.0), 4.0, 0.1);
    EXPECT_EQ(power(0.0, 1.1), power(0.0, 1.0));                  // held
    EXPECT_NEAR(power(2.0, 1.1) / power(2.0, 1.0), 1.21, 1e-12);  // its own
    EXPECT_TRUE(distortion_sources({}, c).empty());
}

// The variation is that of contact_force_variation(), which takes the largest of four wheels that hardly differ and
// sums its lines one by one.
TEST(ContactDistortion, KnowsHowMuchTheForcesVary) {
    CaseParameters c = tests::paper_case(1);
    c.solver.moving = true;
    EXPECT_NEAR(
        contact_distortion(c, 33.0, [](double) { return 1.0; }).force_variation / contact_force_variation(c, 33.0), 1.0,
        0.02);
    EXPECT_NEAR(
        contact_distortion(c, 33.0, [](double) { return 4.0; }).force_variation / contact_force_variation(c, 33.0), 2.0,
        0.04);
}

}  // namespace
}  // namespace railpem::pem

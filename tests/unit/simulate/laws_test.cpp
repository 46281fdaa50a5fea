#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "parameters/parameter_error.hpp"
#include "simulate/numerics/relaxation_chain.hpp"
#include "simulate/track/pad_curve.hpp"
#include "simulate/vehicle/contact_law.hpp"
#include "simulate/vehicle/vehicle_model.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::simulate {
namespace {

TEST(RelaxationChain, FollowsThePowerLaws) {
    for (const double exponent : {0.02, 0.1, 0.15, 0.25, 0.35}) {
        track::PadParameters pads{.exponent = exponent};
        const RelaxationChain chain = pad_chain(pads);
        // Stated in the README: 2e-4 at 0.15, 6e-4 at 0.35 (modulus, 1 to 400 Hz).
        EXPECT_LT(chain.largest_error, 1e-3) << exponent;
        for (const double strength : chain.strength) EXPECT_GT(strength, 0.0);
        EXPECT_GE(chain.equilibrium, 0.0);
    }
    for (const double loss : {0.05, 0.3, 1.0}) {
        track::PadParameters pads{.loss_factor = loss};
        EXPECT_LT(pad_chain(pads).largest_error, 2e-3) << loss;
        const auto at_30 = pad_chain(pads).modulus({0.0, 2.0 * std::numbers::pi * 30.0});
        EXPECT_NEAR(at_30.imag() / at_30.real(), loss, 2e-3 * loss + 1e-3);
        EXPECT_NEAR(at_30.real(), 1.0, 2e-3);
    }
}

TEST(RelaxationChain, BareSpringAndDashpot) {
    track::PadParameters pads{.damping_n_s_per_m = 7e4};
    EXPECT_TRUE(pad_chain(pads).strength.empty());
    EXPECT_EQ(pad_dashpot_n_s_per_m(pads), 7e4);
    pads.loss_factor = 0.2;
    EXPECT_EQ(pad_dashpot_n_s_per_m(pads), 0.0) << "the causal loss law replaces the dashpot";
    pads.loss_law = track::LossLaw::constant;
    EXPECT_EQ(pad_dashpot_n_s_per_m(pads), 7e4);
}

TEST(RelaxationChain, MeasuredTable) {
    // A table sampled from a three-parameter solid must be met again: it lies in the family of the chains.
    track::PadParameters pads;
    for (double f = 0.4; f < 900.0; f *= 1.05) {
        const std::complex<double> s(0.0, 2.0 * std::numbers::pi * f);
        const std::complex<double> solid = 1.0 + 0.8 * s * 2e-3 / (1.0 + s * 2e-3);
        pads.table_frequency_hz.push_back(f);
        pads.table_storage_ratio.push_back(solid.real());
        pads.table_loss_factor.push_back(solid.imag() / solid.real());
    }
    EXPECT_LT(pad_chain(pads).largest_error, 0.02);
}

// Wei et al. 2016: 1.8 mm and 19.1 kN/mm under clips and rail, F(S) polynomial (2).
TEST(PadCurve, TangentFollowsTheLoad) {
    auto c = tests::paper_case(3);
    const PadCurve fixed = static_curve(c.track, {});
    const PadCurve vibrating = dynamic_curve(c.track, {});
    EXPECT_NEAR(fixed.tangent(0.0), 19.1e6, 0.1e6);
    EXPECT_NEAR(vibrating.tangent(0.0), 1.4 * fixed.tangent(0.0), 1e-6 * fixed.tangent(0.0));
    const auto polynomial = [&](double s) {
        return -451.8 + s * (5.021e6 + s * (3.368e9 + s * (1.228e11 + s * 4.01e13)));
    };
    double s0 = 1e-3;
    const double unloaded = 20e3 + 60.0 * 9.81 * 0.6;
    for (int i = 0; i < 60; ++i) s0 -= (polynomial(s0) - unloaded) / (polynomial(s0 + 1e-7) - polynomial(s0)) * 1e-7;
    for (const double x : {-0.5e-3, 0.3e-3, 1.2e-3, 2.0e-3})
        EXPECT_NEAR(fixed.force(x) / (polynomial(s0 + x) - unloaded), 1.0, 2e-5) << x;
    for (const double force : {-5e3, 3e3, 15e3, 30e3}) {
        EXPECT_NEAR(fixed.force(fixed.compression(force)), force, 1e-6);
        EXPECT_NEAR(vibrating.tangent(vibrating.compression(force)) / fixed.tangent(fixed.compression(force)), 1.4,
                    1e-4);
    }
}

/// Through the points; at an inner one, neighbours at the same distance, the harmonic mean of the secants beside it
/// (Fritsch & Butland 1984), at the ends and beyond them the secant.
TEST(PadCurve, GivenPointByPoint) {
    auto c = tests::paper_case(3);
    track::PadParameters& pads = c.track.pads;
    pads.force_polynomial_n.clear();
    pads.curve_compression_m = {1.0e-3, 1.5e-3, 2.0e-3, 2.5e-3, 3.0e-3};
    pads.curve_force_n = {8e3, 14e3, 22e3, 34e3, 52e3};
    const PadCurve curve = static_curve(c.track, {});
    const double unloaded = 20e3 + 60.0 * 9.81 * 0.6;
    const auto place = [&](std::size_t i) { return curve.compression(pads.curve_force_n[i] - unloaded); };
    const auto secant = [&](std::size_t i) { return (pads.curve_force_n[i + 1] - pads.curve_force_n[i]) / 0.5e-3; };
    // A table in steps of 2 µm, of which lines and a cubic are drawn: over one step the slope changes by 0.2 % at most,
    // over the curve it misses 1e-9 m.
    for (std::size_t i = 1; i < 5; ++i) EXPECT_NEAR(place(i) - place(i - 1), 0.5e-3, 1e-8) << i;
    for (std::size_t i = 1; i < 4; ++i) {
        const double mean = 2.0 * secant(i - 1) * secant(i) / (secant(i - 1) + secant(i));
        EXPECT_NEAR(curve.tangent(place(i)) / mean, 1.0, 2e-3) << i;
    }
    EXPECT_NEAR(curve.tangent(place(0) - 1e-4) / secant(0), 1.0, 2e-3);
    EXPECT_NEAR(curve.tangent(place(4) + 1e-4) / secant(3), 1.0, 2e-3);
}

TEST(PadCurve, DeadBandCarriesATenth) {
    auto c = tests::paper_case(1);
    const double gap = 2e-4;
    const PadDeadBand play{.gap_m = gap, .at_load_n = 10e3};
    const PadCurve curve = dynamic_curve(c.track, play);
    const double k = 1.4 * 26.7e6;
    const double start = 10e3 / k;
    EXPECT_TRUE(is_nonlinear(c.track.pads, play));
    EXPECT_FALSE(is_nonlinear(c.track.pads, {}));
    EXPECT_NEAR(curve.tangent(start + 0.5 * gap), 0.1 * k, 1e-6 * k);
    EXPECT_NEAR(curve.tangent(start + 3.0 * gap), k, 1e-6 * k);
    EXPECT_NEAR(curve.force(0.9 * start), 9e3, 1.0);
    EXPECT_LT(curve.force(start + gap) - 10e3, 0.25 * k * gap);
    EXPECT_NEAR(curve.force(-1e-4), -1e-4 * k, 1e-3 * 1e-4 * k);
}

TEST(PadCurve, RefusesACurveThatFalls) {
    auto c = tests::paper_case(3);
    c.track.pads.force_polynomial_n = {1000.0, -5e6};
    EXPECT_THROW(static_curve(c.track, {}), parameters::ParameterError);
}

TEST(ContactLaw, HertzAndItsTangent) {
    const ContactLaw law{.constant_m_per_n23 = worn_tread_constant(0.42), .static_load_n = 80e3, .nonlinearity = 1.0};
    EXPECT_NEAR(law.constant_m_per_n23, 4.265e-8, 1e-11);  // Wei et al. 2016 with R = 0.42 m
    EXPECT_NEAR(contact_stiffness(law), 1.515e9, 1e6);
    const double approach = static_approach(law);
    EXPECT_NEAR(contact_force(law, approach).force, 80e3, 1e-6);
    EXPECT_NEAR(contact_force(law, approach).slope, contact_stiffness(law), 1.0);
    EXPECT_NEAR(contact_force(law, 1.3 * approach).force, std::pow(1.3 * approach / law.constant_m_per_n23, 1.5), 1e-6);
    EXPECT_EQ(contact_force(law, -1e-6).force, 0.0);
}

TEST(ContactLaw, SharesOfNonlinearityAreContinuousAndNeverPull) {
    for (const double phi : {0.5, 1.0, 1.7, 3.0, 5.0}) {
        const ContactLaw law{.constant_m_per_n23 = 4.265e-8, .static_load_n = 80e3, .nonlinearity = phi};
        double before = 0.0;
        for (double y = -0.2; y < 2.0; y += 1e-4) {
            const double force = contact_force(law, y * static_approach(law)).force;
            EXPECT_GE(force, before - 1e-6) << phi << " at " << y;
            EXPECT_LT(force - before, 80e3 * 1e-3 * (1.0 + phi)) << phi << " at " << y;
            before = force;
        }
    }
    const ContactLaw linear{.constant_m_per_n23 = 4.265e-8, .static_load_n = 80e3, .nonlinearity = 0.0};
    EXPECT_NEAR(contact_force(linear, 0.0).force, 80e3 - 1.5 * 80e3, 1e-6);
}

TEST(VehicleModel, HalfTheMassesWholeSprings) {
    const auto c = tests::paper_case(1);
    const VehicleModel model = vehicle_model(c.vehicle, {});
    ASSERT_EQ(model.mass.size(), 10);
    EXPECT_EQ(model.mass[0], 19250.0);
    EXPECT_EQ(model.mass[6], 675.0);
    Eigen::VectorXd heave = Eigen::VectorXd::Zero(10);
    for (const int i : {0, 2, 4, 6, 7, 8, 9}) heave[i] = 1.0;
    EXPECT_LT((model.stiffness * heave).norm(), 1e-6) << "rising as a whole strains nothing";
    EXPECT_NEAR(heave.dot(model.mass.cwiseProduct(heave)), 0.5 * (38500 + 2 * 2980 + 4 * 1350), 1e-9);
    EXPECT_EQ(model.stiffness(0, 0), 2 * 2.5e6);
    EXPECT_EQ(model.stiffness(6, 6), 2.1e6);
    Eigen::VectorXd pitch = Eigen::VectorXd::Zero(10);  // the car turning about its centre, everything with it
    pitch << 0, 1, 9, 1, -9, 1, 10.2, 7.8, -7.8, -10.2;
    EXPECT_LT((model.stiffness * pitch).norm(), 1e-6) << "turning as a whole strains nothing";
}

TEST(VehicleModel, AttachmentsAddTheirDegreesOfFreedom) {
    auto c = tests::paper_case(1);
    c.vehicle.body_bending = {{}};
    c.vehicle.wheelset_bending = {{}};
    c.vehicle.bogie_mounted_masses = {{}, {}};
    OnlyHereParameters extra;
    extra.axle_absorber.mass_kg = 80;
    extra.axle_absorber.wheel = 2;
    extra.body_coupling.stiffness_n_per_m = 1e6;
    const VehicleModel model = vehicle_model(c.vehicle, extra);
    EXPECT_EQ(model.mass.size(), 10 + 1 + 4 + 4 + 1 + 1);
    EXPECT_EQ(model.mass[10], 4500.0);
    EXPECT_NEAR((model.stiffness - model.stiffness.transpose()).norm(), 0.0, 1e-9);
}

TEST(VehicleModel, FrictionOpposesAndSlopesAreDerivatives) {
    const NonlinearElement friction{.direction = {}, .force_n = 1000.0};
    EXPECT_NEAR(force_of(friction, 0.01).force, 1000.0, 1e-6);
    EXPECT_NEAR(force_of(friction, -0.01).force, -1000.0, 1e-6);
    const NonlinearElement sticking{.direction = {}, .force_n = 1000.0, .static_excess = 0.6};
    EXPECT_GT(force_of(sticking, 0.002).force, 1400.0);
    EXPECT_NEAR(force_of(sticking, 0.1).force, 1000.0, 1e-3);
    const NonlinearElement stop{
        .direction = {}, .law = NonlinearElement::Law::bump_stop, .stiffness_n_per_m = 1e6, .gap_m = 0.01};
    EXPECT_EQ(force_of(stop, 0.009).force, 0.0);
    EXPECT_NEAR(force_of(stop, -0.012).force, -2000.0, 1e-9);
    for (const NonlinearElement& element : {friction, sticking, stop})
        for (const double y : {-0.013, -3e-4, 2e-4, 0.004, 0.02}) {
            const double h = 1e-8;
            const double numerical = (force_of(element, y + h).force - force_of(element, y - h).force) / (2.0 * h);
            EXPECT_NEAR(force_of(element, y).slope, numerical, 1e-5 * std::abs(numerical) + 1.0);
        }
}

}  // namespace
}  // namespace railpem::simulate

// The convected rail against the residues of its polynomial dispersion relation (viscous foundation, Euler beam), whose roots
// are found here as eigenvalues of a companion matrix; against Gauss quadrature of the laws of real tracks; and against its resting limit.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "../pem/paper_case.hpp"
#include "track/convected_rail.hpp"
#include "track/pad_law.hpp"
#include "track/rail_damper.hpp"
#include "track/support_law.hpp"

namespace {

using namespace railpem;
using namespace std::complex_literals;
using Complex = std::complex<double>;

constexpr double kEi = 2.06e11 * 3.22e-5, kMass = 60.64, kSpacing = 0.6;

/// 1/2π ∫ e^{ikx}/(EIk⁴ − m(ω − kv)² + (K + i(ω − kv)c)/L) dk = i·Σ residues with Im k > 0 (x ≥ 0), −i·Σ with Im k < 0 (x < 0).
Complex by_residues(double stiffness, double damping, double omega, double v, double x) {
    const Complex c0 = -kMass * omega * omega + (stiffness + 1.0i * omega * damping) / kSpacing;
    const Complex c1 = 2.0 * kMass * omega * v - 1.0i * v * damping / kSpacing;
    const Complex c2 = -kMass * v * v;
    Eigen::Matrix4cd companion = Eigen::Matrix4cd::Zero();
    companion(1, 0) = companion(2, 1) = companion(3, 2) = 1.0;
    companion(0, 3) = -c0 / kEi;
    companion(1, 3) = -c1 / kEi;
    companion(2, 3) = -c2 / kEi;
    const Eigen::Vector4cd roots = companion.eigenvalues();
    const double half = x >= 0.0 ? 1.0 : -1.0;
    Complex sum = 0.0;
    for (const Complex k : roots)
        if (half * k.imag() > 0.0) sum += half * 1.0i * std::exp(1.0i * k * x) / (4.0 * kEi * k * k * k + 2.0 * c2 * k + c1);
    return sum;
}

track::ExactRail smeared(double damping) {
    track::TrackParameters track;
    track.rail = {.youngs_modulus_pa = 2.06e11, .second_moment_of_area_m4 = 3.22e-5, .mass_kg_per_m = kMass};
    track.pads.static_stiffness_n_per_m = 37.38e6;
    track.pads.damping_n_s_per_m = damping;
    return track::uniform_rail(track, {0.0}, 37.38e6);
}

std::vector<track::ConvectedChange> changes(const track::ExactRail& rail, double stiffness, double omega, double v, const std::vector<double>& distances) {
    std::vector<track::ConvectedChange> result(distances.size());
    track::convected_change(rail, stiffness, omega, v, distances, result.data());
    return result;
}

class Convected : public testing::TestWithParam<double> {};

TEST_P(Convected, AgainstResidues) {
    const double damping = GetParam();
    const track::ExactRail rail = smeared(damping);
    const std::vector<double> distances{0.0, 2.4, 15.6, 20.4};
    for (const double v : {10.0, 22.2222, 60.0})
        for (const double f : {1.0, 20.0, 57.6, 120.0, 400.0}) {
            const double omega = 2.0 * std::numbers::pi * f;
            const std::vector<track::ConvectedChange> change = changes(rail, 37.38e6, omega, v, distances);
            const double scale = std::abs(by_residues(37.38e6, damping, omega, 0.0, 0.0));
            for (std::size_t i = 0; i < distances.size(); ++i) {
                const double x = distances[i];
                const Complex at_rest = by_residues(37.38e6, damping, omega, 0.0, x);
                const Complex ahead = by_residues(37.38e6, damping, omega, v, x) - at_rest, behind = by_residues(37.38e6, damping, omega, v, -x) - at_rest;
                EXPECT_NEAR(std::abs(change[i].ahead - ahead) / scale, 0.0, 1e-6) << f << " Hz, " << v << " m/s, x = " << x;
                EXPECT_NEAR(std::abs(change[i].behind - behind) / scale, 0.0, 1e-6) << f << " Hz, " << v << " m/s, x = -" << x;
            }
        }
}
INSTANTIATE_TEST_SUITE_P(Damping, Convected, testing::Values(7.5e4, 1.0e4));

/// The change is first order in the speed for a damped foundation and vanishes with it.
TEST(ConvectedRail, VanishesWithSpeed) {
    const track::ExactRail rail = smeared(7.5e4);
    EXPECT_EQ(changes(rail, 37.38e6, 300.0, 0.0, {0.0})[0].ahead, Complex(0.0));
    const double slow = std::abs(changes(rail, 37.38e6, 300.0, 0.1, {2.4})[0].ahead);
    const double slower = std::abs(changes(rail, 37.38e6, 300.0, 0.01, {2.4})[0].ahead);
    EXPECT_NEAR(slow / slower, 10.0, 0.05);
}

/// Reciprocity is lost, but for reversed motion it returns: R_ij(v) = R_ji(−v), so ahead and behind swap their difference sign to first order.
TEST(ConvectedRail, AheadAndBehindDiffer) {
    const track::ConvectedChange change = changes(smeared(7.5e4), 37.38e6, 360.0, 22.2, {2.4})[0];
    EXPECT_GT(std::abs(change.ahead - change.behind), 0.5 * std::abs(change.ahead));
}

/// 1/D from the laws of the parameters, one wavenumber at a time; of the motion only ω' = ω − kv.
Complex density(const track::TrackParameters& track, double stiffness, double convected, double k) {
    const double w = std::max(std::abs(convected), 1e-9), f = w / (2.0 * std::numbers::pi);
    const track::RailParameters& rail = track.rail;
    const Complex pad = stiffness * track::pad_shape(track.pads, f) + 1.0i * w * track::pad_damping(track.pads);
    const Complex mass = rail.mass_kg_per_m + track::damper_mass_kg_per_m(track.rail_dampers, f);
    const Complex loss(1.0, rail.loss_factor), b = rail.youngs_modulus_pa * rail.second_moment_of_area_m4 * loss;
    Complex bent = b * k * k * k * k;
    if (rail.beam == track::Beam::timoshenko) {
        const Complex s = rail.shear_coefficient * rail.shear_modulus_pa * rail.cross_section_m2 * loss;
        const double r = w * w * rail.mass_kg_per_m * rail.second_moment_of_area_m4 / rail.cross_section_m2;
        bent = s * k * k * (b * k * k - r) / (b * k * k + s - r);
    }
    const Complex d = bent - w * w * mass + track::support_stiffness(pad, track::support_receptance(track.support, f)) / track.spacing_m;
    return 1.0 / (convected < 0.0 ? std::conj(d) : d);
}

/// The reference: composite Gauss–Legendre (five points) to both sides of the break at ω' = 0, k = ω/v, panels growing away from it up to
/// 0.03 rad/m among the waves of the rail, reach 10⁴ rad/m (a rail that shears needs it: the change falls off with k^−2 only). Everything differs from the sum in question but the integral itself.
struct Reference {
    std::vector<double> k;
    std::vector<Complex> weighted;  ///< weight·(1/D_v − 1/D_0)/2π

    Reference(const track::TrackParameters& track, double stiffness, double omega, double v) {
        constexpr double at[]{0.0, 0.538469310105683091, 0.906179845938663993}, w[]{0.568888888888888889, 0.478628670499366468, 0.236926885056189088};
        const double middle = omega / v, reach = 1e4;
        for (const double side : {-1.0, 1.0})
            for (double from = 0.0, size = 1e-5; from < reach + middle; from += size, size = std::min(std::abs(middle + side * from) < 41.0 ? 0.03 : 0.3 + 1e-3 * from, 1.3 * size))
                for (int n = -2; n <= 2; ++n) {
                    const double x = middle + side * (from + 0.5 * size * (1.0 + (n < 0 ? -1.0 : 1.0) * at[std::abs(n)]));
                    if (std::abs(x) > reach) continue;
                    k.push_back(x);
                    weighted.push_back(w[std::abs(n)] * size / (4.0 * std::numbers::pi) * (density(track, stiffness, omega - v * x, x) - density(track, stiffness, omega, x)));
                }
    }
    Complex at(double x) const {
        Complex sum = 0.0;
        for (std::size_t i = 0; i < k.size(); ++i) sum += weighted[i] * std::polar(1.0, k[i] * x);
        return sum;
    }
};

struct RealTrack {
    const char* name;
    track::TrackParameters track;
};

std::vector<RealTrack> real_tracks() {
    std::vector<RealTrack> tracks;
    tracks.push_back({"case 1", tests::paper_case(1).track});
    tracks.push_back({"case 3", tests::paper_case(3).track});
    tracks.push_back({"causal pads", tests::paper_case(3).track});
    tracks.back().track.pads.causal = true;
    tracks.push_back({"hysteretic pads", tests::paper_case(1).track});
    tracks.back().track.pads.damping_n_s_per_m = 0.0;
    tracks.back().track.pads.loss_factor = 0.25;
    tracks.back().track.pads.loss_law = track::LossLaw::constant;
    track::TrackParameters ballasted;
    ballasted.rail = {.beam = track::Beam::timoshenko, .youngs_modulus_pa = 210e9, .second_moment_of_area_m4 = 3038.3e-8, .mass_kg_per_m = 60.2,
                      .loss_factor = 0.02, .shear_modulus_pa = 81e9, .shear_coefficient = 0.4, .cross_section_m2 = 60.2 / 7850.0};
    ballasted.pads = {.static_stiffness_n_per_m = 300e6, .loss_factor = 0.25, .loss_law = track::LossLaw::constant};
    ballasted.support = {.model = track::SupportModel::two_layer, .mass_kg = 162.0, .stiffness_n_per_m = 50e6, .loss_factor = 1.0};
    tracks.push_back({"ballasted", ballasted});
    tracks.push_back({"ballasted, bending sleepers", ballasted});
    tracks.back().track.support.bending_modes = {{.frequency_hz = 120.0, .loss_factor = 0.02, .modal_mass_kg = 80.0}};
    tracks.push_back({"rail dampers", tests::paper_case(1).track});
    tracks.back().track.rail_dampers = {{.mass_kg_per_m = 15.0, .frequency_hz = 120.0, .loss_factor = 0.3}};
    return tracks;
}

/// Every law of pads, sleepers and dampers, at rest smooth or with a break at ω' = 0: within 1e-3 of the change or 1e-5 of the
/// receptance at rest. The same distances as between the wheels of a car.
TEST(ConvectedRail, AgainstGaussQuadrature) {
    const std::vector<double> distances{0.0, 2.4, 15.6, 20.4};
    for (const RealTrack& t : real_tracks()) {
        const double stiffness = t.track.pads.static_stiffness_n_per_m * t.track.pads.dynamic_to_static_ratio;
        const track::ExactRail rail = track::uniform_rail(t.track, {0.0}, stiffness);
        double worst = 0.0;
        for (const double v : {10.0, 22.0, 40.0, 60.0})
            for (const double f : {3.0, 8.0, 20.0, 57.6, 118.0, 200.0}) {
                const double omega = 2.0 * std::numbers::pi * f;
                const std::vector<track::ConvectedChange> change = changes(rail, stiffness, omega, v, distances);
                const Reference reference(t.track, stiffness, omega, v);
                double at_rest = 0.0;
                {
                    Complex sum = 0.0;
                    for (double k = -40.0; k < 40.0; k += 0.02) sum += 0.02 / (2.0 * std::numbers::pi) * density(t.track, stiffness, omega, k);
                    at_rest = std::abs(sum);
                }
                for (std::size_t i = 0; i < distances.size(); ++i)
                    for (const double side : {1.0, -1.0}) {
                        const Complex expected = reference.at(side * distances[i]), found = side > 0.0 ? change[i].ahead : change[i].behind;
                        const double error = std::abs(found - expected), allowed = std::max(1e-3 * std::abs(expected), 1e-5 * at_rest);
                        worst = std::max(worst, error / allowed);
                        EXPECT_LE(error, allowed) << t.name << ", " << f << " Hz, " << v << " m/s, x = " << side * distances[i];
                    }
            }
        std::printf("%-28s largest error: %.3f of what is allowed\n", t.name, worst);
    }
}

}  // namespace

// The exact infinite rail against independent solutions written here: the Green function of the free infinite beam
// (Euler in closed form; Timoshenko by residues of its dispersion relation) with the pads as point springs, solved
// densely.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "track/rail/exact_rail.hpp"

namespace {

using namespace railpem;
using namespace std::complex_literals;
using Complex = std::complex<double>;

track::TrackParameters paper_track() {
    track::TrackParameters track;
    track.rail = {.youngs_modulus_pa = 2.06e11, .second_moment_of_area_m4 = 3.22e-5, .mass_kg_per_m = 60.64};
    track.pads.static_stiffness_n_per_m = 26.7e6;
    track.pads.dynamic_to_static_ratio = 1.4;
    track.pads.exponent = 0.15;
    track.pads.damping_n_s_per_m = 7.5e4;
    return track;
}

track::TrackParameters uic60_track() {
    track::TrackParameters track;
    track.rail = {.beam = track::Beam::timoshenko,
                  .youngs_modulus_pa = 210e9,
                  .second_moment_of_area_m4 = 3038.3e-8,
                  .mass_kg_per_m = 60.2,
                  .loss_factor = 0.02,
                  .shear_modulus_pa = 81e9,
                  .shear_coefficient = 0.4,
                  .cross_section_m2 = 60.2 / 7850.0};
    track.pads.static_stiffness_n_per_m = 300e6;
    track.pads.loss_factor = 0.25;
    track.pads.loss_law = track::LossLaw::constant;
    track.support = {
        .model = track::SupportModel::two_layer, .mass_kg = 162.0, .stiffness_n_per_m = 50e6, .loss_factor = 1.0};
    return track;
}

/// Displacement at distance x of the free infinite beam per unit force. Both theories by residues of
/// w(k) = N(k)/D(k), D = (Bk² + S − ω²ρI)(Sk² − μ) − S²k², N = Bk² + S − ω²ρI (S = κGA); Euler: 1/(Bk⁴ − μ).
Complex green(const track::RailParameters& rail, double omega, double x) {
    const Complex b = rail.youngs_modulus_pa * rail.second_moment_of_area_m4 * Complex(1.0, rail.loss_factor);
    const double mu = rail.mass_kg_per_m * omega * omega;
    if (rail.beam == track::Beam::euler) {
        // e^{+iωt} with loss: the travelling wave is exp(−iκ|x|), so the residue form is −(e^{−κx} +
        // i·e^{−iκx})/(4Bκ³).
        const Complex kappa = std::pow(mu / b, 0.25);
        return -(std::exp(-kappa * x) + 1.0i * std::exp(-1.0i * kappa * x)) / (4.0 * b * kappa * kappa * kappa);
    }
    const Complex s =
        rail.shear_coefficient * rail.shear_modulus_pa * rail.cross_section_m2 * Complex(1.0, rail.loss_factor);
    const double rotary = omega * omega * rail.mass_kg_per_m * rail.second_moment_of_area_m4 / rail.cross_section_m2;
    // D = B·S·k⁴ + k²(−Bμ + S² − S·rot − S²) − μ(S − rot)
    const Complex a2 = b * s, a1 = -b * mu - s * rotary, a0 = -mu * (s - rotary);
    const Complex root = std::sqrt(a1 * a1 - 4.0 * a2 * a0);
    Complex sum = 0.0;
    for (const double sign : {1.0, -1.0}) {
        Complex k = std::sqrt((-a1 + sign * root) / (2.0 * a2));
        if (k.imag() > 0.0) k = -k;  // decays for x > 0 as exp(−ikx) with Im k < 0
        const Complex derivative = 4.0 * a2 * k * k * k + 2.0 * a1 * k;
        sum += (b * k * k + s - rotary) / derivative * std::exp(-1.0i * k * x);
    }
    return -1.0i * sum;
}

Complex support_stiffness(const track::TrackParameters& track, double k0, double omega) {
    const double f = omega / (2.0 * std::numbers::pi);
    const track::PadParameters& pads = track.pads;
    const Complex pad = k0 * std::pow(f / pads.reference_frequency_hz, pads.exponent) * Complex(1.0, pads.loss_factor) +
                        1.0i * omega * pads.damping_n_s_per_m;
    if (track.support.model == track::SupportModel::rigid) return pad;
    const Complex below = track.support.stiffness_n_per_m * Complex(1.0, track.support.loss_factor) -
                          omega * omega * track.support.mass_kg;
    return 1.0 / (1.0 / pad + 1.0 / below);
}

/// Receptance matrix of points on an infinite free beam on `pads` point springs, and the sum of the pad forces.
struct Brute {
    Eigen::MatrixXcd receptance;
    Eigen::VectorXcd pad_sum;
    double end_force;  ///< largest force left in the outermost pads: how far the ends have decayed
};

Brute brute_force(const track::TrackParameters& track, const std::vector<double>& pads, const std::vector<double>& k0,
                  const std::vector<double>& points, double omega) {
    const long n = static_cast<long>(pads.size()), m = static_cast<long>(points.size());
    Eigen::MatrixXcd gpp(n, n), gpw(n, m), gww(m, m);
    Eigen::VectorXcd stiffness(n);
    for (long i = 0; i < n; ++i) {
        stiffness(i) = support_stiffness(track, k0[static_cast<std::size_t>(i)], omega);
        for (long j = 0; j < n; ++j) gpp(i, j) = green(track.rail, omega, std::abs(pads[i] - pads[j]));
        for (long j = 0; j < m; ++j) gpw(i, j) = green(track.rail, omega, std::abs(pads[i] - points[j]));
    }
    for (long i = 0; i < m; ++i)
        for (long j = 0; j < m; ++j) gww(i, j) = green(track.rail, omega, std::abs(points[i] - points[j]));
    Eigen::MatrixXcd system = gpp;
    system.diagonal() += stiffness.cwiseInverse();
    const Eigen::MatrixXcd force = system.partialPivLu().solve(gpw);
    const double end_force = std::max(force.row(0).cwiseAbs().maxCoeff(), force.row(n - 1).cwiseAbs().maxCoeff());
    return {gww - gpw.transpose() * force, force.colwise().sum().transpose(), end_force};
}

lanes::Real same_omega(double frequency) {
    return lanes::broadcast(2.0 * std::numbers::pi * frequency);
}

track::StaticEquilibrium made_up_equilibrium(int count, double uniform) {
    track::StaticEquilibrium equilibrium;
    equilibrium.unloaded_dynamic_stiffness_n_per_m = uniform;
    const int middle = (count - 1) / 2;
    for (int j = 0; j < count; ++j) {
        const double x = (j - middle) * 0.6;
        equilibrium.position_m.push_back(x);
        const double loaded = std::exp(-std::pow(std::abs(std::abs(x) - 9.0) / 2.0, 2));
        equilibrium.dynamic_stiffness_n_per_m.push_back(uniform * (1.0 + loaded));
    }
    return equilibrium;
}

struct Setting {
    const char* name;
    track::TrackParameters track;
    double uniform, from_hz, to_hz;
    int pads;
};

class AgainstGreen : public testing::TestWithParam<int> {};

Setting setting(int index) {
    if (index == 0) return {"paper", paper_track(), 37.38e6, 5.0, 400.0, 161};
    return {"uic60", uic60_track(), 300e6, 20.0, 3000.0, 301};
}

/// Wheels of the paper's car, one of them moved into a bay; 1e-8 relative where the ends of the reference have decayed.
TEST_P(AgainstGreen, ReceptancesAndPadSum) {
    const Setting s = setting(GetParam());
    const std::vector<double> wheels{10.2, 7.93, -7.8, -10.11};
    const track::StaticEquilibrium equilibrium = made_up_equilibrium(s.pads, s.uniform);
    const track::ExactRail rail = track::exact_rail(s.track, wheels, equilibrium);
    track::ExactRailWorkspace workspace(rail);
    for (const double frequency : {s.from_hz, std::sqrt(s.from_hz * s.to_hz), 0.5 * s.to_hz, s.to_hz}) {
        const track::RailReceptance& exact = track::rail_receptance(rail, same_omega(frequency), workspace);
        const Brute brute = brute_force(s.track, equilibrium.position_m, equilibrium.dynamic_stiffness_n_per_m, wheels,
                                        2.0 * std::numbers::pi * frequency);
        const double scale = std::abs(brute.receptance(0, 0));
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j) {
                EXPECT_NEAR(std::abs(exact.at(i, j)[0] - brute.receptance(i, j)) / scale, 0.0, 1e-8)
                    << s.name << " " << frequency << " Hz, " << i << j;
                EXPECT_EQ(exact.at(i, j)[3], exact.at(j, i)[3]);
            }
            // The pads beyond the reference's end carry a geometric series of what its last pad carries.
            EXPECT_NEAR(std::abs(exact.trackbed[i][0] - brute.pad_sum(i)), 0.0, 1e-8 + 100.0 * brute.end_force)
                << s.name << " " << frequency << " Hz, pad sum " << i;
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Tracks, AgainstGreen, testing::Values(0, 1));

/// The table of track/README.md: largest difference from the reference over all sixteen receptances, relative to that
/// of wheel 1.
TEST(ExactRailAccuracy, Table) {
    fmt::print("| track | frequency Hz | receptances | pad sum |\n|---|---|---|---|\n");
    const std::vector<double> wheels{10.2, 7.93, -7.8, -10.11};
    for (const int index : {0, 1}) {
        const Setting s = setting(index);
        for (const double frequency :
             index == 0 ? std::vector{5.0, 66.7, 200.0, 400.0} : std::vector{20.0, 200.0, 1000.0, 3000.0}) {
            // Less than 1 dB/m near the pinned–pinned frequency: the ends of the reference must be far away.
            const track::StaticEquilibrium equilibrium =
                made_up_equilibrium(frequency == 1000.0 ? 701 : s.pads, s.uniform);
            const track::ExactRail rail = track::exact_rail(s.track, wheels, equilibrium);
            track::ExactRailWorkspace workspace(rail);
            const track::RailReceptance& exact = track::rail_receptance(rail, same_omega(frequency), workspace);
            const Brute brute = brute_force(s.track, equilibrium.position_m, equilibrium.dynamic_stiffness_n_per_m,
                                            wheels, 2.0 * std::numbers::pi * frequency);
            double largest = 0.0, pad_sum = 0.0;  // the reference lacks the pad forces beyond its ends
            for (int i = 0; i < 4; ++i) {
                pad_sum = std::max(pad_sum, std::abs(exact.trackbed[i][0] - brute.pad_sum(i)));
                for (int j = 0; j < 4; ++j)
                    largest = std::max(largest, std::abs(exact.at(i, j)[0] - brute.receptance(i, j)));
            }
            largest /= std::abs(brute.receptance(0, 0));
            fmt::print("| {} | {:g} | {:.1e} | {:.1e} |\n", s.name, frequency, largest, pad_sum);
            EXPECT_LT(largest, 1e-8);
        }
    }
}

/// The closed form of the Euler element (e.g. Clough & Penzien): K11 = EIκ³(cosh·sin + sinh·cos)/(1 − cosh·cos) and so
/// on.
TEST(RailElement, EulerClosedForm) {
    const track::TrackParameters track = paper_track();
    const double length = 0.6, ei = 2.06e11 * 3.22e-5;
    for (const double frequency : {40.0, 300.0, 2000.0, 5000.0}) {
        const double omega = 2.0 * std::numbers::pi * frequency;
        const double kappa = std::pow(60.64 * omega * omega / ei, 0.25), x = kappa * length;
        const double denominator = 1.0 - std::cosh(x) * std::cos(x);
        const track::RailElement element =
            track::rail_element(track::beam_coefficients(track.rail, {}, lanes::broadcast(omega)), length);
        const double k3 = ei * kappa * kappa * kappa;
        // the closed form itself loses digits in its denominator at small x (x⁴/6 from terms of 1)
        const double tolerance = 1e-9;
        EXPECT_NEAR(
            element.near.a[0].real() / (k3 * (std::cosh(x) * std::sin(x) + std::sinh(x) * std::cos(x)) / denominator),
            1.0, tolerance)
            << frequency;
        EXPECT_NEAR(element.far.a[0].real() / (-k3 * (std::sin(x) + std::sinh(x)) / denominator), 1.0, tolerance)
            << frequency;
        EXPECT_NEAR(element.near.b[0].real() / (ei * kappa * kappa * std::sinh(x) * std::sin(x) / denominator), 1.0,
                    tolerance)
            << frequency;
        EXPECT_NEAR(element.near.d[0].real() /
                        (ei * kappa * (std::cosh(x) * std::sin(x) - std::sinh(x) * std::cos(x)) / denominator),
                    1.0, tolerance)
            << frequency;
    }
}

/// ω → 0: the static Hermite element plus −ω² times the consistent mass; the next term is ω⁴·(mℓ⁴/EI), about 1e-9 at
/// 0.1 Hz.
TEST(RailElement, StaticLimit) {
    const double length = 0.6, ei = 2.06e11 * 3.22e-5;
    const track::RailElement element =
        track::rail_element(track::beam_coefficients(paper_track().rail, {}, same_omega(0.1)), length);
    EXPECT_NEAR(element.near.a[0].real() / (12.0 * ei / std::pow(length, 3)), 1.0, 1e-6);
    EXPECT_NEAR(element.near.b[0].real() / (6.0 * ei / std::pow(length, 2)), 1.0, 1e-6);
    const double rigid = (element.near.a[0] + element.far.a[0]).real() * 2.0;  // force for a unit rigid heave: −ω²·mℓ
    EXPECT_NEAR(rigid / (-std::pow(0.2 * std::numbers::pi, 2) * 60.64 * length), 1.0, 1e-4);
}

/// Shear stiffness to infinity and rotary inertia to nothing: Timoshenko becomes Euler.
TEST(RailElement, TimoshenkoBecomesEuler) {
    track::RailParameters rail = paper_track().rail;
    const lanes::Real omega = same_omega(500.0);
    const track::RailElement euler = track::rail_element(track::beam_coefficients(rail, {}, omega), 0.6);
    rail.beam = track::Beam::timoshenko;
    rail.second_moment_of_area_m4 = 3.22e-5;
    double previous = 1.0;
    for (const double factor : {1e2, 1e4, 1e6}) {
        rail.shear_modulus_pa = 81e9 * factor;
        rail.cross_section_m2 = 7.7e-3 * factor;  // rotary inertia mI/A falls with the area
        const track::RailElement shear = track::rail_element(track::beam_coefficients(rail, {}, omega), 0.6);
        const double difference = std::abs(shear.near.a[0] / euler.near.a[0] - 1.0);
        EXPECT_LT(difference, previous / 20.0);
        previous = difference;
    }
}

/// A stretch of rail is the same whether taken whole or in two unequal pieces.
TEST(RailElement, PiecesAddUp) {
    const track::BeamCoefficients beam = track::beam_coefficients(uic60_track().rail, {}, same_omega(2500.0));
    const track::RailElement one = track::rail_element(beam, 0.25), two = track::rail_element(beam, 0.35),
                             whole = track::rail_element(beam, 0.6);
    const lanes::Matrix2 middle = lanes::inverse(track::mirrored(one.near) + two.near);
    const lanes::Matrix2 near = one.near - one.far * middle * transpose(one.far);
    const lanes::Matrix2 far = lanes::Matrix2{} - one.far * middle * two.far;
    EXPECT_NEAR(std::abs(near.a[0] / whole.near.a[0] - 1.0), 0.0, 1e-11);
    EXPECT_NEAR(std::abs(far.b[0] / whole.far.b[0] - 1.0), 0.0, 1e-11);
}

/// Without any damping the wave that travels outwards is taken: the receptance is the limit of vanishing loss, and the
/// power put in is never negative. Both propagating and stop bands of the undamped track are crossed.
TEST(HalfTrack, UndampedIsTheLimitOfSmallLoss) {
    track::TrackParameters track = paper_track();
    track.pads.damping_n_s_per_m = 0.0;
    track.pads.exponent = 0.0;
    track::TrackParameters lossy = track;
    lossy.rail.loss_factor = 1e-8;
    for (double frequency = 50.0; frequency < 3000.0; frequency *= 1.037) {
        const track::ExactRail rail = track::uniform_rail(track, {0.0, 0.3}, 37.38e6);
        const track::ExactRail other = track::uniform_rail(lossy, {0.0, 0.3}, 37.38e6);
        track::ExactRailWorkspace workspace(rail), other_workspace(other);
        const Complex undamped = track::rail_receptance(rail, same_omega(frequency), workspace).at(0, 0)[0];
        const Complex limit = track::rail_receptance(other, same_omega(frequency), other_workspace).at(0, 0)[0];
        EXPECT_NEAR(std::abs(undamped / limit - 1.0), 0.0, 1e-4) << frequency;  // loss 1e-8 over a quality of some 1e3
        EXPECT_LE(undamped.imag(), 1e-6 * std::abs(undamped)) << frequency;
    }
}

/// Dense supports become a continuous foundation s per metre: w(0)/F = 1/(8·EI·β³) with 4·EI·β⁴ = s − mω² (Winkler
/// beam).
TEST(ExactRail, DenseSupportsAreAWinklerFoundation) {
    track::TrackParameters track = paper_track();
    track.pads.exponent = 0.0;
    track.spacing_m = 0.1;  // the discreteness enters with (spacing·wavenumber)⁴ ≈ 1e-4
    const double omega = 2.0 * std::numbers::pi * 60.0;
    const Complex per_metre = Complex(37.38e6 / 6.0, omega * 7.5e4 / 6.0) / 0.1;
    track.pads.damping_n_s_per_m = 7.5e4 / 6.0;
    const Complex beta = std::pow((per_metre - 60.64 * omega * omega) / (4.0 * 2.06e11 * 3.22e-5), 0.25);
    const Complex closed = 1.0 / (8.0 * 2.06e11 * 3.22e-5 * beta * beta * beta);
    const track::ExactRail rail = track::uniform_rail(track, {0.0}, 37.38e6 / 6.0);
    track::ExactRailWorkspace workspace(rail);
    EXPECT_NEAR(std::abs(track::rail_receptance(rail, lanes::broadcast(omega), workspace).at(0, 0)[0] / closed - 1.0),
                0.0, 1e-4);
}

}  // namespace

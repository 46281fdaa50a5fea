// The modal rail against solutions that share no code with it: the endless Euler beam's Green function with point pads,
// the Winkler foundation in closed form, and the pinned–pinned frequency. Prints the convergence table of
// track/README.md.

#include "track/rail/modal_rail.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/unit/track/wei2016_track.hpp"
#include "track/pads/pad_positions.hpp"

namespace railpem::track {
namespace {

using Complex = std::complex<double>;
constexpr Complex imaginary{0.0, 1.0};
constexpr double ei = 2.06e11 * 3.22e-5, mass = 60.64;

/// Displacement of the endless free beam at distance x for a unit force, e^{+iωt} (Graff 1975, section 3.1.5).
Complex green(double omega, double x) {
    const double kappa = std::pow(mass * omega * omega / ei, 0.25);
    return -(std::exp(-kappa * x) + imaginary * std::exp(-imaginary * kappa * x)) / (4.0 * ei * kappa * kappa * kappa);
}

Eigen::MatrixXcd green(double omega, const std::vector<double>& to, const std::vector<double>& from) {
    Eigen::MatrixXcd g(to.size(), from.size());
    for (std::size_t i = 0; i < to.size(); ++i)
        for (std::size_t j = 0; j < from.size(); ++j) g(i, j) = green(omega, std::abs(to[i] - from[j]));
    return g;
}

/// Receptance at the wheels of an endless rail on point pads of stiffness K: R = G_ww − G_wp (1/K + G_pp)⁻¹ G_pw.
Eigen::MatrixXcd exact_receptance(double f, const std::vector<double>& wheels, const std::vector<double>& pads,
                                  Complex k) {
    const double omega = 2.0 * std::numbers::pi * f;
    Eigen::MatrixXcd flexibility = green(omega, pads, pads);
    flexibility.diagonal().array() += 1.0 / k;
    return green(omega, wheels, wheels) -
           green(omega, wheels, pads) * flexibility.partialPivLu().solve(green(omega, pads, wheels));
}

/// The pads of case 2 of the paper, eq. (10): one K0 for all.
Complex paper_pad(double f) {
    return {1.4 * 26.7e6 * std::pow(f / 4.0, 0.15), 2.0 * std::numbers::pi * f * 7.5e4};
}

Eigen::MatrixXcd modal_receptance(double f, int pads, int modes, Complex k) {
    const TrackParameters track = wei2016_track();
    const ModalRail rail = modal_rail(track, pad_positions(track, wei2016_wheels_m, pads), wei2016_wheels_m, modes);
    return modal_receptance(rail, f, Eigen::VectorXcd::Constant(pads, k)).at_points;
}

/// Largest relative error of the driving-point receptances.
double error_against_exact(double f, int pads, int modes, const Eigen::MatrixXcd& exact) {
    const Eigen::MatrixXcd found = modal_receptance(f, pads, modes, paper_pad(f));
    double largest = 0.0;
    for (int j = 0; j < 4; ++j) largest = std::max(largest, std::abs(found(j, j) / exact(j, j) - 1.0));
    return largest;
}

/// What the modes above N would add to a driving-point receptance below their frequencies, sin² taken as ½ on average:
/// Σ_{n>N} (1/(mL))/ω_n² ≈ (L/N)³/(3π⁴EI).
double truncated_compliance(double length_m, int modes) {
    return std::pow(length_m / modes, 3) / (3.0 * std::pow(std::numbers::pi, 4) * ei);
}

const std::vector<double> table_frequencies{1.0, 30.0, 66.7, 100.0, 150.0, 200.0};

std::vector<Eigen::MatrixXcd> exact_references() {
    const std::vector<double> pads = pad_positions(wei2016_track(), wei2016_wheels_m, 301);
    std::vector<Eigen::MatrixXcd> references;
    for (const double f : table_frequencies)
        references.push_back(exact_receptance(f, wei2016_wheels_m, pads, paper_pad(f)));
    return references;
}

TEST(ModalRailConvergence, LengthAndModes) {
    const std::vector<Eigen::MatrixXcd> exact = exact_references();
    fmt::print("| pads | length m | modes | highest mode Hz |");
    for (const double f : table_frequencies) fmt::print(" {:g} Hz |", f);
    fmt::print("\n|---|---|---|---|---|---|---|---|---|---|\n");
    const auto row = [&](int pads, int modes) {
        const double length = pads * 0.6;
        const double highest = 0.5 * std::numbers::pi * std::pow(modes / length, 2) * std::sqrt(ei / mass);
        fmt::print("| {} | {:.1f} | {} | {:.0f} |", pads, length, modes, highest);
        std::vector<double> errors;
        for (std::size_t i = 0; i < exact.size(); ++i) {
            errors.push_back(error_against_exact(table_frequencies[i], pads, modes, exact[i]));
            fmt::print(" {:.1e} |", errors.back());
        }
        fmt::print("\n");
        return errors;
    };
    row(61, 30);
    const std::vector<double> usual = row(61, 60), fine = row(61, 120), finest = row(61, 240);
    const std::vector<double> short_rail = row(41, 161), medium = row(51, 201), long_rail = row(81, 319),
                              longest = row(101, 397);
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double size = exact[i].diagonal().cwiseAbs().minCoeff();
        EXPECT_LT(usual[i],
                  1.3 * truncated_compliance(36.6, 60) / size);  // cut within the first dip of sin² over the pads
        EXPECT_LT(fine[i], truncated_compliance(36.6, 120) / size);
        EXPECT_LT(finest[i], truncated_compliance(36.6, 240) / size);
        EXPECT_LT(longest[i], truncated_compliance(60.6, 397) / size);
        // Length matters no more once the ends are e^{−7} away; at 41 pads they are 2 m from the wheels.
        EXPECT_NEAR(long_rail[i], longest[i], 0.01 * longest[i]);
        EXPECT_LT(medium[i] - longest[i], 1e-4);  // ends 5 m behind the last wheels: e^{−10}, there and back
        EXPECT_GT(short_rail[i], 10.0 * longest[i]);
    }
}

TEST(ModalRailConvergence, ThirdOrderInTheNumberOfModes) {
    // The missing modes act as springs, whose sum falls as N⁻³. sin² over the pads repeats every 2·41 modes; whole
    // periods show the order undisturbed.
    const double f = 66.7;
    const auto at = [&](int modes) { return modal_receptance(f, 41, modes, paper_pad(f))(1, 1); };
    const Complex coarse = at(164), middle = at(328), fine = at(656);
    const double order = std::log2(std::abs(middle - coarse) / std::abs(fine - middle));
    fmt::print("order in modes {:.3f}\n", order);
    EXPECT_NEAR(order, 3.0, 0.15);
}

TEST(ModalRail, DensePadsAreAWinklerFoundation) {
    TrackParameters track = wei2016_track();
    track.spacing_m = 0.1;
    const std::vector<double> wheel{0.0};
    const ModalRail rail = modal_rail(track, pad_positions(track, wheel, 301), wheel, 300);
    for (const double f : {5.0, 50.0, 100.0}) {
        const double omega = 2.0 * std::numbers::pi * f;
        const Complex foundation = paper_pad(f) / 0.6;
        // Endless beam on a Winkler foundation: the free beam's Green function with κ⁴ = (mω² − k)/EI, Im κ < 0 < Re κ.
        const Complex kappa = [&] {
            Complex root = std::pow((mass * omega * omega - foundation) / ei, 0.25);
            while (!(root.real() > 0.0 && root.imag() < 0.0)) root *= imaginary;
            return root;
        }();
        const Complex expected = -(1.0 + imaginary) / (4.0 * ei * kappa * kappa * kappa);
        const Complex found =
            modal_receptance(rail, f, Eigen::VectorXcd::Constant(301, foundation * 0.1)).at_points(0, 0);
        const double truncated = truncated_compliance(30.1, 300);
        // Without the missing modes 5e-5 to 8e-5; with them 2e-9 is measured, of which (β·spacing)⁴-effects of the
        // points are part.
        EXPECT_NEAR(std::abs((found + truncated) / expected - 1.0), 0.0, 1e-8) << f;
    }
}

/// Rigid pads: the rail stands still at each and vibrates between them, first at (π/2L²)√(EI/m). Without loss the
/// receptance at mid-bay has a pole there and none below.
TEST(ModalRail, RigidPadsGiveThePinnedPinnedFrequency) {
    const double bay = 0.6, pinned = 0.5 * std::numbers::pi / (bay * bay) * std::sqrt(ei / mass);
    TrackParameters track = wei2016_track();
    track.spacing_m =
        2.0 * bay;  // so that the rail ends one whole bay beyond the outermost pads, and every span is alike
    std::vector<double> pads;
    for (int j = -5; j <= 5; ++j) pads.push_back(bay * j);
    const ModalRail rail = modal_rail(track, pads, {0.5 * bay}, 240);
    const auto inverse = [&](double f) {
        return 1.0 / modal_receptance(rail, f, Eigen::VectorXcd::Constant(11, 1e13)).at_points(0, 0).real();
    };
    for (double f = 0.05 * pinned; f < 0.995 * pinned; f += 0.05 * pinned) EXPECT_GT(inverse(f), 0.0) << f;
    double low = 0.995 * pinned, high = 1.003 * pinned;  // the next of the twelve modes of the band lies at 1.02
    ASSERT_LT(inverse(high), 0.0);
    while (high - low > 1e-7 * pinned) (inverse(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
    EXPECT_NEAR(low / pinned, 1.0, 1e-6);
}

}  // namespace
}  // namespace railpem::track

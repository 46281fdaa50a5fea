#include "track/convected_rail.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace railpem::track {

using lanes::Complex;
using lanes::Real;

namespace {

/// Terms of the sum at most: a wave that decays less than 1e-3 per metre is cut short rather than computed for ever.
constexpr double kMostTerms = 60000.0;
constexpr double kLogImages = 20.7;   ///< −log 1e-9
constexpr double kReach = 12.0;       ///< in wavenumbers of the rail on its supports; the change falls off with its sixth power

/// 1/D(ω', k) for a group of wavenumbers; ω' may be negative.
Complex receptance_density(const ExactRail& rail, double pad_stiffness, Real convected, Real k) {
    const Real small = lanes::broadcast(1e-6);
    Real size = convected < Real{} ? -convected : convected;
    size = size < small ? small : size;
    const BeamCoefficients beam = beam_coefficients(rail.rail, rail.dampers, size);
    const Complex support = SupportLaw(rail.pads, rail.support, size).stiffness(pad_stiffness);
    const Real k2 = k * k;
    const Complex bending = beam.bending * k2;
    Complex stiffness = bending * k2;
    if (rail.rail.beam == Beam::timoshenko) {
        const Complex shear = lanes::reciprocal(beam.shear_compliance);
        stiffness = shear * (bending + (-beam.rotary)) / (bending + shear + (-beam.rotary)) * k2;
    }
    // The rail's loss factor is a constant loss: its sign follows ω' like everything that dissipates.
    Complex sum = stiffness - beam.inertia + support * (1.0 / rail.spacing_m);
    sum.im = convected < Real{} ? -sum.im : sum.im;
    return lanes::reciprocal(sum);
}

struct Grid {
    double step;
    int groups;  ///< of lanes::width wavenumbers, on each side of zero
};

Grid wavenumber_grid(const ExactRail& rail, double pad_stiffness, double omega, const std::vector<double>& separations) {
    const Complex support = SupportLaw(rail.pads, rail.support, lanes::broadcast(omega)).stiffness(pad_stiffness);
    const BeamCoefficients beam = beam_coefficients(rail.rail, rail.dampers, lanes::broadcast(omega));
    const std::complex<double> fourth = (beam.inertia[0] - support[0] / rail.spacing_m) / beam.bending[0];
    const std::complex<double> root = std::pow(fourth, 0.25);  // and root·i^n
    const double decay = std::max(1e-4, std::min(std::abs(root.imag()), std::abs(root.real())));
    const double foundation = std::pow(std::abs(support[0]) / rail.spacing_m / std::abs(beam.bending[0]), 0.25);
    const double reach = kReach * std::max(std::abs(root), foundation);
    double farthest = 0.0;
    for (const double x : separations) farthest = std::max(farthest, std::abs(x));
    const double step = std::max(2.0 * std::numbers::pi / (farthest + kLogImages / decay), 2.0 * reach / kMostTerms);
    return {step, static_cast<int>(std::ceil(reach / step / lanes::width))};
}

}  // namespace

std::vector<std::complex<double>> convected_change(const ExactRail& rail, double pad_stiffness_n_per_m, double omega, double speed_m_per_s,
                                                   const std::vector<double>& separations_m) {
    std::vector<std::complex<double>> change(separations_m.size());
    if (speed_m_per_s == 0.0) return change;
    const Grid grid = wavenumber_grid(rail, pad_stiffness_n_per_m, omega, separations_m);
    std::vector<Complex> sums(separations_m.size());
    for (int group = -grid.groups; group < grid.groups; ++group) {
        Real k;
        for (int lane = 0; lane < lanes::width; ++lane) k[lane] = (group * lanes::width + lane + 0.5) * grid.step;  // zero stays between two points
        const Complex moving = receptance_density(rail, pad_stiffness_n_per_m, omega - speed_m_per_s * k, k);
        const Complex resting = receptance_density(rail, pad_stiffness_n_per_m, lanes::broadcast(omega), k);
        const Complex difference = moving - resting;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i] += difference * lanes::polar(lanes::broadcast(1.0), k * separations_m[i]);
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        for (int lane = 0; lane < lanes::width; ++lane) change[i] += sums[i][lane] * (grid.step / (2.0 * std::numbers::pi));
    return change;
}

}  // namespace railpem::track

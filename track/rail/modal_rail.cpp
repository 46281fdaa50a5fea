#include "track/rail/modal_rail.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cassert>
#include <cmath>
#include <numbers>

#include "parameters/parameter_error.hpp"
#include "track/elements/rail_damper.hpp"

namespace railpem::track {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using parameters::ParameterError;

namespace {

/// φ_n at the positions (from the rear end of the rail), positions × modes.
MatrixXd mode_shapes(const std::vector<double>& x_m, double length_m, double mass_kg_per_m, int modes) {
    MatrixXd shapes(static_cast<Eigen::Index>(x_m.size()), modes);
    const double amplitude = std::sqrt(2.0 / (mass_kg_per_m * length_m));
    for (Eigen::Index i = 0; i < shapes.rows(); ++i)
        for (Eigen::Index n = 0; n < modes; ++n)
            shapes(i, n) = amplitude * std::sin(static_cast<double>(n + 1) * std::numbers::pi * x_m[i] / length_m);
    return shapes;
}

std::vector<double> shifted(const std::vector<double>& x_m, double origin_m) {
    std::vector<double> result = x_m;
    for (double& x : result) x -= origin_m;
    return result;
}

}  // namespace

ModalRail modal_rail(const TrackParameters& track, const std::vector<double>& pads_m,
                     const std::vector<double>& points_m, int modes, const TrackModifiers& modifiers) {
    assert(!pads_m.empty());
    if (track.rail.beam == Beam::timoshenko)
        throw ParameterError("solver.rail", "the modal rail is an Euler beam, the case asks for a Timoshenko rail",
                             "solver.rail = \"exact\", or track.rail.beam = \"euler\"");
    if (modes < 1) throw ParameterError("solver.modes", "a modal rail without modes", "at least 1");
    const double rear = pads_m.front() - 0.5 * track.spacing_m;
    const double length = pads_m.back() + 0.5 * track.spacing_m - rear;
    for (const double x : points_m)
        if (x < rear || x > rear + length)
            throw ParameterError(
                "solver.pads",
                fmt::format("a wheel stands at {:g} m, off the rail, which reaches from {:g} m to {:g} m", x, rear,
                            rear + length),
                "more pads");
    const RailParameters& rail = track.rail;
    const double wave = std::sqrt(rail.youngs_modulus_pa * rail.second_moment_of_area_m4 / rail.mass_kg_per_m);
    ModalRail result;
    result.circular_frequency_rad_per_s.resize(modes);
    for (Eigen::Index n = 0; n < modes; ++n)
        result.circular_frequency_rad_per_s[n] =
            wave * std::pow(static_cast<double>(n + 1) * std::numbers::pi / length, 2);
    result.pad_shape = mode_shapes(shifted(pads_m, rear), length, rail.mass_kg_per_m, modes);
    result.point_shape = mode_shapes(shifted(points_m, rear), length, rail.mass_kg_per_m, modes);
    result.loss_factor = rail.loss_factor;
    result.mass_kg_per_m = rail.mass_kg_per_m;
    result.dampers = track.rail_dampers;
    result.mass_factor = modifiers.rail;
    return result;
}

ModalReceptance modal_receptance(const ModalRail& rail, double frequency_hz,
                                 const Eigen::VectorXcd& seat_stiffness_n_per_m) {
    assert(frequency_hz > 0.0 && seat_stiffness_n_per_m.size() == rail.pad_shape.rows());
    const double omega = 2.0 * std::numbers::pi * frequency_hz;
    std::complex<double> mass_ratio = 1.0 + damper_mass_kg_per_m(rail.dampers, frequency_hz) / rail.mass_kg_per_m;
    if (!rail.mass_factor.empty()) mass_ratio *= rail.mass_factor.at(omega);
    const std::complex<double> rigidity(1.0, rail.loss_factor);

    // Real and imaginary part apart: half the work of a complex product with real mode shapes.
    const auto& shape = rail.pad_shape;
    MatrixXcd stiffness(shape.cols(), shape.cols());
    stiffness.real().noalias() = shape.transpose() * (seat_stiffness_n_per_m.real().asDiagonal() * shape);
    stiffness.imag().noalias() = shape.transpose() * (seat_stiffness_n_per_m.imag().asDiagonal() * shape);
    stiffness.diagonal() += rail.circular_frequency_rad_per_s.array().square().matrix() * rigidity;
    stiffness.diagonal().array() -= omega * omega * mass_ratio;

    const MatrixXcd modal = stiffness.partialPivLu().solve(rail.point_shape.transpose().cast<std::complex<double>>());
    ModalReceptance result;
    result.at_points = rail.point_shape * modal;
    result.at_pads = shape * modal;
    result.trackbed = seat_stiffness_n_per_m.transpose() * result.at_pads;
    return result;
}

}  // namespace railpem::track

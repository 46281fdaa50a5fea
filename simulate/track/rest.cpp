#include "simulate/track/rest.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "parameters/parameter_error.hpp"
#include "simulate/track/solve_track.hpp"

namespace railpem::simulate {

namespace {

/// Branches slower than this do not follow the passage of a vehicle.
constexpr double passage_s = 0.3;

double foot_compliance(const TrackWindow& track, const Seat& seat) {
    double sum = 0.0;
    for (std::size_t r = 0; r < track.law.oscillators.size(); ++r)
        sum += 1.0 / (seat.oscillator_scale[r] * track.law.oscillators[r].stiffness_n_per_m);
    return sum;
}

/// Pad and foot in series at rail displacement w: compression, force and the slope dF/d(−w).
struct SeatRest {
    double compression, force, slope;
};

SeatRest seat_rest(const TrackWindow& track, const Seat& seat, const PadCurve& curve, double modulus, double w) {
    const double compliance = foot_compliance(track, seat);
    const double gain = seat.share * modulus;
    double x = -w / (1.0 + compliance * gain * curve.tangent(0.0));
    for (int pass = 0; pass < 40; ++pass) {
        const double change =
            (x + w + compliance * gain * curve.force(x)) / (1.0 + compliance * gain * curve.tangent(x));
        x -= change;
        if (std::abs(change) < 1e-15) break;
    }
    const double tangent = gain * curve.tangent(x);
    return {x, gain * curve.force(x), tangent / (1.0 + compliance * tangent)};
}

using Sparse = Eigen::SparseMatrix<double>;

Sparse rail_stiffness(const TrackWindow& track, const Section& section) {
    const Eigen::Matrix4d k = element_stiffness(section, track.element_m);
    const auto n = static_cast<Eigen::Index>(track.nodes());
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index e = -1; e < n; ++e)  // one element beyond either end, clamped there
        for (Eigen::Index i = 0; i < 4; ++i)
            for (Eigen::Index j = 0; j < 4; ++j) {
                const Eigen::Index row = 2 * e + i;
                const Eigen::Index column = 2 * e + j;
                if (std::min(row, column) >= 0 && std::max(row, column) < 2 * n)
                    entries.emplace_back(row, column, k(i, j));
            }
    Sparse matrix(2 * n, 2 * n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Eigen::VectorXd load_vector(const TrackWindow& track, const Section& section, const std::vector<double>& position_m,
                            double load_n) {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(track.nodes()));
    for (const double position : position_m) {
        const double place = position - static_cast<double>(track.first_seat) * track.spacing_m;
        const double element = std::floor(place / track.element_m);
        const Eigen::Vector4d shape = displacement_shape(section, track.element_m, place - element * track.element_m);
        load.segment<4>(2 * static_cast<Eigen::Index>(element)) -= load_n * shape;
    }
    return load;
}

}  // namespace

Rest find_rest(const TrackWindow& track, const Section& section, const PadCurve& curve, double modulus,
               const std::vector<double>& position_m, double load_n) {
    const Sparse rail = rail_stiffness(track, section);
    const Eigen::VectorXd load = load_vector(track, section, position_m, load_n);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(load.size());
    Rest rest;
    rest.compression_m.resize(track.seats.size());
    rest.force_n.resize(track.seats.size());
    Eigen::SimplicialLDLT<Sparse> solver;
    for (int iteration = 0; iteration < 60; ++iteration) {
        Eigen::VectorXd unbalanced = load - rail * u;
        Sparse jacobian = rail;
        for (std::size_t i = 0; i < track.seats.size(); ++i) {
            const Eigen::Index at = 2 * static_cast<Eigen::Index>(i) * track.elements_per_bay;
            const SeatRest seat = seat_rest(track, track.seats[i], curve, modulus, u[at]);
            rest.compression_m[i] = seat.compression;
            rest.force_n[i] = seat.force;
            unbalanced[at] += seat.force;
            jacobian.coeffRef(at, at) += seat.slope;
        }
        rest.residual_n = unbalanced.lpNorm<Eigen::Infinity>();
        if (rest.residual_n < 1e-9 * std::max(1.0, load_n)) break;
        solver.compute(jacobian);
        u += solver.solve(unbalanced);
    }
    if (!(rest.residual_n < 1e-6 * std::max(1.0, load_n)))
        throw parameters::ParameterError("track.pads", "the pads find no equilibrium under the wheels",
                                         "a static curve that carries the wheel load");
    for (std::size_t k = 0; k < track.nodes(); ++k) {
        rest.w.push_back(u[2 * static_cast<Eigen::Index>(k)]);
        rest.theta.push_back(u[2 * static_cast<Eigen::Index>(k) + 1]);
    }
    return rest;
}

void start_moving(TrackWindow& track, const PadCurve& curve, const std::vector<double>& position_m, double load_n) {
    const RelaxationChain& chain = track.law.chain;
    double modulus = chain.equilibrium;
    for (std::size_t b = 0; b < chain.strength.size(); ++b)
        if (chain.time_s[b] > passage_s) modulus += chain.strength[b];
    const Rest rest = find_rest(track, track.section, curve, modulus, position_m, load_n);
    track.w = rest.w;
    track.theta = rest.theta;
    for (std::size_t d = 0; d < track.dampers.size(); ++d)
        for (std::size_t k = 0; k < track.nodes(); ++k) track.damper_motion[d][k].displacement_m = rest.w[k];
    for (std::size_t i = 0; i < track.seats.size(); ++i) {
        Seat& seat = track.seats[i];
        seat.compression_m = rest.compression_m[i];
        for (std::size_t b = 0; b < chain.strength.size(); ++b)
            seat.branch_force_n[b] = chain.time_s[b] > passage_s ? 0.0 : curve.force(rest.compression_m[i]);
        for (std::size_t r = 0; r < track.law.oscillators.size(); ++r)
            seat.oscillators[r].displacement_m =
                -rest.force_n[i] / (seat.oscillator_scale[r] * track.law.oscillators[r].stiffness_n_per_m);
    }
}

void start_standing(TrackWindow& track, const RadauStep& step, const Section& static_section,
                    const PadCurve& static_curve, const std::vector<double>& position_m, double load_n) {
    const Rest rest = find_rest(track, static_section, static_curve, 1.0, position_m, load_n);
    for (std::size_t i = 0; i < track.seats.size(); ++i) {
        Seat& seat = track.seats[i];
        seat.origin_m = track.law.curve.compression(static_curve.force(rest.compression_m[i]));
        seat.reference_stiffness_n_per_m = track.law.curve.tangent(seat.origin_m);
        set_stiffness(seat, track.law, track.seat_numbers, step);
    }
    factorise_track(track);
}

}  // namespace railpem::simulate

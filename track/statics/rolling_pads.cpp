#include "track/statics/rolling_pads.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>
#include <unsupported/Eigen/FFT>

#include "parameters/parameter_error.hpp"
#include "track/elements/rail_element.hpp"
#include "track/pads/pad_curve.hpp"
#include "track/pads/pad_law.hpp"
#include "track/pads/seat_law.hpp"
#include "track/pads/support_law.hpp"
#include "track/statics/anderson_mixing.hpp"

namespace railpem::track {

using lanes::Complex;
using lanes::Real;

namespace {

using Phasor = std::complex<double>;

constexpr int kCurvePoints = 300;  ///< of E
constexpr double kBeyond = 3.0;    ///< times the load that could come on one pad, where the table of E ends
constexpr double kSoftest = 1e-2;  ///< of K_secant: s > 1 takes all stiffness away from pads that carry little
constexpr int kStepsPerBay = 12;   ///< three per wave of the fourth order
constexpr double kRun_m = 40.0;    ///< before and behind the outermost wheels
/// of a single load at rest, which sends no waves: soft pads let the rail sink to 1/e in 1.5 m
constexpr double kStandingRun_m = 12.0;
constexpr int kAliases = 8;  ///< terms of Σ_m on each side; they fall with m⁻⁴
/// under the standing rail, where D(0) would vanish; 1e-8 of what the pads give
constexpr double kSoftBed_n_per_m2 = 1.0;
constexpr double kSettled_hz = 0.5;
constexpr double kTowardsStiffest = 0.25;
constexpr double kAccuracy = 1e-10;
constexpr int kMostIterations = 200;

struct Grid {
    double step_m = 0.0;
    std::size_t size = 64;  ///< a power of two
    double first_m() const { return -0.5 * static_cast<double>(size) * step_m; }
    double wavenumber_step() const { return 2.0 * std::numbers::pi / (static_cast<double>(size) * step_m); }
    std::size_t wavenumbers() const { return size / 2 + 1; }
};

Grid grid_of(const TrackParameters& track, const std::vector<double>& wheels_m, double run_m) {
    double farthest = 0.0;
    for (const double wheel : wheels_m) farthest = std::max(farthest, std::abs(wheel));
    Grid grid{.step_m = track.spacing_m / kStepsPerBay};
    while (static_cast<double>(grid.size) * grid.step_m < 2.0 * (farthest + run_m)) grid.size *= 2;
    return grid;
}

Real wavenumbers_from(const Grid& grid, std::size_t first) {
    Real k;
    for (int lane = 0; lane < lanes::width; ++lane)
        k[lane] = static_cast<double>(first + static_cast<std::size_t>(lane)) * grid.wavenumber_step();
    return k;
}

Real at_least(Real x, double least) {
    const Real floor = lanes::broadcast(least);
    return x < floor ? floor : x;
}

/// g times the pads' factor, and iωc times it.
struct Memory {
    Complex shape, dashpot;
};

Memory memory_at(const PadParameters& pads, Real omega, const lanes::FactorCurve& factor) {
    const Real settled = lanes::broadcast(kSettled_hz), frequency = omega / (2.0 * std::numbers::pi),
               x = frequency / settled, x2 = x * x;
    const Complex own = pad_shape(pads, at_least(frequency, kSettled_hz)), relaxing(x2 / (1.0 + x2), x / (1.0 + x2));
    Memory memory{own, {Real{}, omega * pad_damping(pads)}};
    memory.shape.re = x < 1.0 ? own.re - own.im + 2.0 * own.im * relaxing.re : own.re;
    memory.shape.im = x < 1.0 ? 2.0 * own.im * relaxing.im : own.im;
    if (factor.empty()) return memory;
    const Complex own_factor = factor.at(at_least(omega, 2.0 * std::numbers::pi * kSettled_hz));
    return {memory.shape * own_factor, memory.dashpot * own_factor};
}

/// The linear part of the equation of one pad, at every κ ≥ 0.
struct Equation {
    /// D(−κ, κv) times what the loads alone move, e^{iκ·first}/step: as a discrete transform; of constant ones Σ
    /// P·e^{iκ(a + first)}/step
    std::vector<Phasor> load;
    std::vector<Phasor> free;     ///< D(−κ, κv)
    std::vector<Phasor> carried;  ///< D(−κ, κv)·(Σ' 1/(L·D) + R) + 1/L
    std::vector<Phasor> shape, dashpot;
};

/// Of a rail under standing loads.
BeamCoefficients still_beam(const TrackParameters& track) {
    BeamCoefficients beam = beam_coefficients(track.rail, {}, Real{});
    beam.bending.im = beam.shear_compliance.im = Real{};
    beam.inertia = Complex(-kSoftBed_n_per_m2);
    return beam;
}

Equation equation_of(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n,
                     double speed, bool standing, const Grid& grid, const std::vector<Phasor>& swelling,
                     const TrackModifiers& modifiers) {
    Equation equation;
    const double bay = 2.0 * std::numbers::pi / track.spacing_m;
    const BeamCoefficients still = still_beam(track);
    std::vector<Phasor> turned(wheels_m.size(), 1.0), turn;  // e^{iκ(a + first)}
    for (const double wheel : wheels_m)
        turn.push_back(std::polar(1.0, grid.wavenumber_step() * (wheel + grid.first_m())));
    for (std::size_t first = 0; first < grid.wavenumbers(); first += lanes::width) {
        const Real k = wavenumbers_from(grid, first), omega = k * (standing ? 0.0 : speed);
        const BeamCoefficients beam =
            standing ? still : beam_coefficients(track.rail, track.rail_dampers, omega, modifiers.rail);
        const Complex free = beam_stiffness(beam, -k);
        Complex aliased;
        for (int m = 1; m <= kAliases; ++m)
            aliased += lanes::reciprocal(beam_stiffness(beam, m * bay - k)) +
                       lanes::reciprocal(beam_stiffness(beam, m * bay + k));
        const Complex below = standing ? Complex(static_support_compliance(track.support))
                                       : support_receptance(track.support, omega, modifiers.support);
        const Complex carried = free * (aliased * (1.0 / track.spacing_m) + below) + 1.0 / track.spacing_m;
        const Memory memory = standing ? Memory{Complex(1.0), Complex()} : memory_at(track.pads, omega, modifiers.pads);
        const Complex ahead = swelling.empty() ? Complex() : free / beam_stiffness(beam, bay - k),
                      behind = swelling.empty() ? Complex() : free / beam_stiffness(beam, bay + k);
        for (int lane = 0; lane < lanes::width && first + static_cast<std::size_t>(lane) < grid.wavenumbers(); ++lane) {
            Phasor load = 0.0;
            for (std::size_t wheel = 0; wheel < wheels_m.size(); ++wheel) {
                load += wheel_load_n * turned[wheel];
                if (!swelling.empty()) {
                    const Phasor own = 0.5 * swelling[wheel] * std::polar(1.0, -bay * wheels_m[wheel]);
                    load += turned[wheel] * (own * ahead[lane] + std::conj(own) * behind[lane]);
                }
                turned[wheel] *= turn[wheel];
            }
            equation.load.push_back(load / grid.step_m);
            equation.free.push_back(free[lane]);
            equation.carried.push_back(carried[lane]);
            equation.shape.push_back(memory.shape[lane]);
            equation.dashpot.push_back(memory.dashpot[lane]);
        }
    }
    return equation;
}

/// E beyond the force at rest, without its linear part.
class ElasticLaw {
  public:
    ElasticLaw(const TrackParameters& track, double wheel_load_n) {
        const TrackParameters passing = passing_track(track, wheel_load_n);
        curve_ = pad_curve(passing.pads);
        rest_m_ = unloaded_seat(seat_law(passing), rest_load_n(passing)).compression_m;
        rest_n_ = pad_force(curve_, rest_m_);
        // No pad carries more than the rest and one wheel, most carry little: between the softest and the stiffest
        // tangent, where both converge fastest together (of 0, 0.1, 0.25, 0.5 and 0.75 a quarter took fewest rounds on
        // the paper's track at 22 m/s: 14 at strength 1.5, half-way 19, at 0 18).
        const double softest = pad_stiffness(curve_, rest_m_);
        reference_ = softest + kTowardsStiffest *
                                   (pad_stiffness(curve_, pad_compression(curve_, rest_n_ + wheel_load_n)) - softest);
        first_slope_ = pad_stiffness(curve_, std::nextafter(curve_.free_compression_m, 1.0));
    }
    double reference() const { return reference_; }
    /// `piece`: of the curve, where the last one was.
    double remainder(double x, std::size_t& piece) const {
        const double below = curve_.free_compression_m - rest_m_ - x;
        const double force = below > 0.0 ? -below * first_slope_ : pad_force(curve_, rest_m_ + x, piece);
        return force - rest_n_ - reference_ * x;
    }

  private:
    PadCurve curve_;
    double rest_m_ = 0.0, rest_n_ = 0.0, reference_ = 0.0, first_slope_ = 0.0;
};

/// x̂ = (load − carried·g·N̂)/pad and N = E(x) − E_rest − K·x, in turn, from the history's x on; returns N̂ and leaves x
/// in the history.
std::vector<Phasor> settle(const Equation& equation, const std::vector<Phasor>& pad, const ElasticLaw& law,
                           double largest_load, PadHistory& history) {
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    const long size = static_cast<long>(history.compression_m.size());
    Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(history.compression_m.data(), size);
    std::vector<double> own(history.compression_m.size());
    std::vector<Phasor> remainder(pad.size()), moved(pad.size());
    AndersonMixing mixing;
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
        std::size_t piece = 0;
        for (long i = 0; i < size; ++i) own[static_cast<std::size_t>(i)] = law.remainder(x(i), piece);
        transform.fwd(remainder, own);
        for (std::size_t n = 0; n < pad.size(); ++n)
            moved[n] = (equation.load[n] - equation.carried[n] * equation.shape[n] * remainder[n]) / pad[n];
        transform.inv(own, moved);
        const Eigen::VectorXd change = Eigen::Map<const Eigen::VectorXd>(own.data(), size) - x;
        const double largest = change.lpNorm<Eigen::Infinity>();
        if (!std::isfinite(largest)) break;
        if (largest * law.reference() < kAccuracy * largest_load) {
            history.compression_m = own;
            return remainder;
        }
        x += mixing.step(x, change);
    }
    throw parameters::ParameterError("track.pads", "the pads find no equilibrium under rolling wheels",
                                     "a static curve that carries the wheel load");
}

}  // namespace

TrackParameters passing_track(const TrackParameters& track, double wheel_load_n) {
    const PadCurve curve = pad_curve(track.pads);
    const double highest = kBeyond * (track.statics.clip_preload_n + wheel_load_n);
    TrackParameters passing = track;
    PadParameters& pads = passing.pads;
    pads.force_polynomial_n.clear();
    pads.curve_compression_m.clear();
    pads.curve_force_n.clear();
    double compression = 0.0, previous = 0.0;
    for (int i = 0; i <= kCurvePoints; ++i) {
        const double force = highest * i / kCurvePoints;
        const double stiffness = initial_dynamic_stiffness(
            track.pads, pad_stiffness(curve, pad_compression(curve, std::max(force, 1e-3 * highest))));
        const double compliance = 1.0 / std::max(stiffness, kSoftest * track.pads.static_stiffness_n_per_m);
        if (i > 0) compression += 0.5 * (compliance + previous) * highest / kCurvePoints;
        previous = compliance;
        pads.curve_compression_m.push_back(compression);
        pads.curve_force_n.push_back(force);
    }
    pads.curve_limit_n = highest;
    passing.statics.second_moment_of_area_m4 = 0.0;
    return passing;
}

namespace {

/// pad_history() on a grid.
PadHistory history_on(const Grid& grid, const TrackParameters& track, const std::vector<double>& wheels_m,
                      double wheel_load_n, double speed_m_per_s, bool standing, const std::vector<Phasor>& swelling_n,
                      const PadHistory* near, const TrackModifiers& modifiers) {
    const Equation equation =
        equation_of(track, wheels_m, wheel_load_n, speed_m_per_s, standing, grid, swelling_n, modifiers);
    PadHistory history{.first_m = grid.first_m(),
                       .step_m = grid.step_m,
                       .compression_m = {},
                       .force_n_m = {},
                       .wavenumber_step_per_m = grid.wavenumber_step()};
    const bool linear = track.pads.preload_strength == 0.0;
    const std::optional<ElasticLaw> law =
        linear ? std::nullopt : std::optional<ElasticLaw>(std::in_place, track, wheel_load_n);
    const double reference =
        linear ? initial_dynamic_stiffness(track.pads, track.pads.static_stiffness_n_per_m) : law->reference();
    std::vector<Phasor> pad(equation.load.size()), remainder;
    for (std::size_t n = 0; n < pad.size(); ++n)
        pad[n] = equation.free[n] + equation.carried[n] * (equation.shape[n] * reference + equation.dashpot[n]);
    if (!linear) {
        history.compression_m = near && near->compression_m.size() == grid.size && near->step_m == grid.step_m
                                    ? near->compression_m
                                    : std::vector<double>(grid.size, 0.0);
        remainder = settle(equation, pad, *law, wheel_load_n, history);
    }
    for (std::size_t n = 0; n < pad.size(); ++n) {
        Phasor force = (equation.shape[n] * reference + equation.dashpot[n]) * equation.load[n];
        if (!linear) force += equation.shape[n] * remainder[n] * equation.free[n];
        const double k = static_cast<double>(n) * grid.wavenumber_step();
        history.force_n_m.push_back(force / pad[n] * std::polar(grid.step_m, -k * grid.first_m()));
    }
    return history;
}

}  // namespace

PadHistory pad_history(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n,
                       double speed_m_per_s, bool standing, const std::vector<Phasor>& swelling_n,
                       const PadHistory* near, const TrackModifiers& modifiers) {
    assert(speed_m_per_s > 0.0 || standing);
    return history_on(grid_of(track, wheels_m, kRun_m), track, wheels_m, wheel_load_n, speed_m_per_s, standing,
                      swelling_n, near, modifiers);
}

std::vector<Phasor> rolling_deflection(const TrackParameters& track, const std::vector<double>& wheels_m, double speed,
                                       const PadHistory& history, int orders, bool standing,
                                       const TrackModifiers& modifiers) {
    const BeamCoefficients still = still_beam(track);
    const double bay = 2.0 * std::numbers::pi / track.spacing_m, step = history.wavenumber_step_per_m;
    const std::size_t wheels = wheels_m.size();
    std::vector<Phasor> result(static_cast<std::size_t>(orders) * wheels), turned(wheels, 1.0), turn;
    for (const double wheel : wheels_m) turn.push_back(std::polar(1.0, -step * wheel));
    for (std::size_t first = 0; first < history.force_n_m.size(); first += lanes::width) {
        Real k;
        Complex force;
        std::vector<Complex> phase(wheels);  // e^{−iκa}
        for (int lane = 0; lane < lanes::width; ++lane) {
            const std::size_t n = first + static_cast<std::size_t>(lane);
            k[lane] = static_cast<double>(n) * step;
            if (n < history.force_n_m.size()) force.set(lane, history.force_n_m[n] * (n == 0 ? 0.5 : 1.0));
            for (std::size_t wheel = 0; wheel < wheels; ++wheel)
                phase[wheel].set(lane, turned[wheel]), turned[wheel] *= turn[wheel];
        }
        const BeamCoefficients beam =
            standing ? still : beam_coefficients(track.rail, track.rail_dampers, k * speed, modifiers.rail);
        for (int m = 1; m <= orders; ++m) {
            // Of −κ the conjugate: D(2πm/L + κ, −κv) = conj D(2πm/L + κ, κv).
            const Complex ahead = force / beam_stiffness(beam, m * bay - k),
                          behind = force / beam_stiffness(beam, m * bay + k);
            for (std::size_t wheel = 0; wheel < wheels; ++wheel) {
                const Complex front = ahead * phase[wheel], rear = behind * phase[wheel],
                              sum(front.re + rear.re, front.im - rear.im);
                for (int lane = 0; lane < lanes::width; ++lane)
                    result[static_cast<std::size_t>(m - 1) * wheels + wheel] += sum[lane];
            }
        }
    }
    for (int m = 1; m <= orders; ++m)
        for (std::size_t wheel = 0; wheel < wheels; ++wheel)
            result[static_cast<std::size_t>(m - 1) * wheels + wheel] *=
                std::polar(-step / (2.0 * std::numbers::pi * track.spacing_m), m * bay * wheels_m[wheel]);
    return result;
}

LoadedDeflection loaded_deflection(const TrackParameters& track, double wheel_load_n) {
    constexpr double kShare = 0.1;  // of the load, either way
    const double step = kShare * wheel_load_n;
    std::array<double, 3> w;
    const Grid grid = grid_of(track, {0.0}, kStandingRun_m);
    PadHistory history;
    for (int i = 0; i < 3; ++i) {
        const PadHistory less = std::move(history);
        history = history_on(grid, track, {0.0}, wheel_load_n + (i - 1) * step, 0.0, true, {}, &less, {});
        // s = 0: the wheel over the pad
        w[static_cast<std::size_t>(i)] = history.compression_m[history.compression_m.size() / 2];
    }
    return {(w[2] - w[0]) / (2.0 * step), (w[2] - 2.0 * w[1] + w[0]) / (step * step)};
}

}  // namespace railpem::track

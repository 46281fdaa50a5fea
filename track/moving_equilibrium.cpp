#include "track/moving_equilibrium.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "parameters/parameter_error.hpp"
#include "track/pad_curve.hpp"
#include "track/pad_law.hpp"
#include "track/seat_law.hpp"

namespace railpem::track {

namespace {

using Phasor = std::complex<double>;

constexpr int kCurvePoints = 300;      ///< of E
constexpr double kBeyond = 3.0;        ///< times the load that could come on one pad, where the table of E ends
constexpr double kSoftest = 1e-2;      ///< of K_secant: s > 1 takes all stiffness away from pads that carry little
constexpr double kStep_m = 0.2;        ///< of the smeared track: a third of a bay of 0.6 m
constexpr double kRun_m = 40.0;        ///< before and behind the outermost wheels
constexpr double kSettled_hz = 0.5;
constexpr double kAccuracy = 1e-10;
constexpr int kMostIterations = 200;

/// The track as passing wheels meet it: E is the pads' only curve.
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
        const double stiffness = initial_dynamic_stiffness(track.pads, pad_stiffness(curve, pad_compression(curve, std::max(force, 1e-3 * highest))));
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

/// The smeared track in the frame of the wheels.
class Smeared {
  public:
    Smeared(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n)
        : passing_(passing_track(track, wheel_load_n)), curve_(pad_curve(passing_.pads)) {
        const SeatLaw seat = seat_law(passing_);
        rest_m_ = unloaded_seat(seat, rest_load_n(passing_)).compression_m;
        rest_n_ = pad_force(curve_, rest_m_);
        double farthest = 0.0;
        for (const double wheel : wheels_m) farthest = std::max(farthest, std::abs(wheel));
        for (size_ = 64; static_cast<double>(size_) * kStep_m < 2.0 * (farthest + kRun_m);) size_ *= 2;
        reference_ = 0.5 * (pad_stiffness(curve_, rest_m_) + pad_stiffness(curve_, pad_compression(curve_, rest_n_ + wheel_load_n)));  // no pad carries more
        for (std::size_t i = 0; i < size_; ++i) {
            Phasor load = 0.0;
            for (const double wheel : wheels_m) load += wheel_load_n / kStep_m * std::polar(1.0, -wavenumber(i) * (wheel - first_m()));
            load_.push_back(load);
        }
    }

    double first_m() const { return -0.5 * static_cast<double>(size_) * kStep_m; }

    /// Elastic compression beyond that at rest, at every point. `with_memory`: as the case has it at speed v; otherwise g = 1 and v = 0.
    std::vector<double> compression(double speed, bool with_memory) {
        std::vector<Phasor> pad(size_), rail(size_);  // per compression: of the whole pad; what carries the load where pad and support move
        std::vector<Phasor> shape(size_);
        const bool layered = passing_.support.model != SupportModel::rigid;
        for (std::size_t i = 0; i < size_; ++i) {
            const double k = wavenumber(i), omega = with_memory ? -k * speed : 0.0;
            shape[i] = with_memory ? shape_at(omega) : Phasor(1.0);
            const Phasor dashpot(0.0, with_memory ? omega * pad_damping(passing_.pads) : 0.0);
            const double below = layered ? 1.0 / passing_.support.stiffness_n_per_m : 0.0;
            const double bending = bending_of(k) - mass_per_m() * omega * omega;
            const Phasor carried = bending * below + 1.0 / passing_.spacing_m;
            rail[i] = carried * shape[i];
            pad[i] = bending + carried * (shape[i] * reference_ + dashpot);
        }
        return solve(rail, pad);
    }

    double stiffness(double compression) const { return pad_stiffness(curve_, rest_m_ + compression); }

  private:
    double wavenumber(std::size_t i) const {
        const double n = static_cast<double>(i) - (2 * i >= size_ ? static_cast<double>(size_) : 0.0);
        return 2.0 * std::numbers::pi * n / (static_cast<double>(size_) * kStep_m);
    }
    double mass_per_m() const {
        double mass = passing_.rail.mass_kg_per_m;
        for (const RailDamper& damper : passing_.rail_dampers) mass += damper.mass_kg_per_m;
        return mass;
    }
    double bending_of(double k) const {
        const RailParameters& rail = passing_.rail;
        const double b = rail.youngs_modulus_pa * rail.second_moment_of_area_m4;
        if (rail.beam == Beam::euler) return b * k * k * k * k;
        return b * k * k * k * k / (1.0 + b * k * k / (rail.shear_modulus_pa * rail.shear_coefficient * rail.cross_section_m2));
    }
    Phasor shape_at(double omega) const {
        const double frequency = std::abs(omega) / (2.0 * std::numbers::pi), x = frequency / kSettled_hz;
        Phasor shape = pad_shape(passing_.pads, std::max(frequency, kSettled_hz));
        if (x < 1.0) shape = shape.real() - shape.imag() + 2.0 * shape.imag() * Phasor(x * x, x) / (1.0 + x * x);
        return omega < 0.0 ? std::conj(shape) : shape;
    }

    /// x from pad·x̂ = load − rail·(E(x) − K_reference·x)^, again and again: the reference is the mean of the softest and the stiffest tangent.
    std::vector<double> solve(const std::vector<Phasor>& rail, const std::vector<Phasor>& pad) {
        std::vector<Phasor> own(size_), transform(size_);
        std::vector<double> x(size_, 0.0);
        const double largest = std::abs(load_.front()) * kStep_m;
        for (int iteration = 0; iteration < kMostIterations; ++iteration) {
            for (std::size_t i = 0; i < size_; ++i) own[i] = pad_force(curve_, rest_m_ + x[i]) - rest_n_ - reference_ * x[i];
            fft_.fwd(transform, own);
            for (std::size_t i = 0; i < size_; ++i) transform[i] = (load_[i] - rail[i] * transform[i]) / pad[i];
            fft_.inv(own, transform);
            double moved = 0.0;
            for (std::size_t i = 0; i < size_; ++i) moved += std::abs(own[i].real() - x[i]), x[i] = own[i].real();
            if (!std::isfinite(moved)) break;
            if (moved * reference_ < kAccuracy * largest) return x;
        }
        throw parameters::ParameterError("track.pads", "the pads find no equilibrium under rolling wheels", "a static curve that carries the wheel load");
    }

    TrackParameters passing_;
    PadCurve curve_;
    Eigen::FFT<double> fft_;
    double rest_m_ = 0.0, rest_n_ = 0.0, reference_ = 0.0;
    std::size_t size_ = 0;
    std::vector<Phasor> load_;
};

bool has_memory(const PadParameters& pads) {
    return pads.exponent != 0.0 || pads.loss_factor != 0.0 || !pads.table_frequency_hz.empty() || pads.damping_n_s_per_m != 0.0;
}

}  // namespace

double PassingChange::at(double position_m) const {
    const double place = (position_m - first_m) / step_m;
    const auto i = static_cast<std::ptrdiff_t>(std::floor(place));
    if (i < 1 || i + 2 >= static_cast<std::ptrdiff_t>(change_n_per_m.size())) return 0.0;
    const double t = place - static_cast<double>(i), *y = &change_n_per_m[static_cast<std::size_t>(i)];
    return -t * (t - 1.0) * (t - 2.0) / 6.0 * y[-1] + (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0 * y[0] - (t + 1.0) * t * (t - 2.0) / 2.0 * y[1] +
           (t + 1.0) * t * (t - 1.0) / 6.0 * y[2];
}

PassingChange passing_change(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n, double speed_m_per_s) {
    PassingChange change;
    if (speed_m_per_s == 0.0 || !has_memory(track.pads)) return change;
    Smeared smeared(track, wheels_m, wheel_load_n);
    const std::vector<double> standing = smeared.compression(0.0, false), rolling = smeared.compression(speed_m_per_s, true);
    change.first_m = smeared.first_m();
    change.step_m = kStep_m;
    for (std::size_t i = 0; i < standing.size(); ++i) change.change_n_per_m.push_back(smeared.stiffness(rolling[i]) - smeared.stiffness(standing[i]));
    return change;
}

StaticEquilibrium moving_equilibrium(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n,
                                     const std::vector<double>& pads_m, const PassingChange& change, const StaticEquilibrium* start) {
    const TrackParameters passing = passing_track(track, wheel_load_n);
    const PadCurve statics = pad_curve(track.pads), elastic = pad_curve(passing.pads);
    StaticEquilibrium result = static_equilibrium(passing, wheels_m, wheel_load_n, pads_m, start);
    for (std::size_t j = 0; j < pads_m.size(); ++j) {
        result.static_stiffness_n_per_m[j] = pad_stiffness(statics, pad_compression(statics, std::max(0.0, pad_force(elastic, result.compression_m[j]))));
        result.dynamic_stiffness_n_per_m[j] = initial_dynamic_stiffness(track.pads, result.static_stiffness_n_per_m[j]) + change.at(pads_m[j]);
    }
    result.unloaded_static_stiffness_n_per_m =
        pad_stiffness(statics, pad_compression(statics, pad_force(elastic, result.unloaded_compression_m)));
    result.unloaded_dynamic_stiffness_n_per_m = initial_dynamic_stiffness(track.pads, result.unloaded_static_stiffness_n_per_m);
    return result;
}

}  // namespace railpem::track

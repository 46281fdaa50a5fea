#include "track/statics/equilibria_abreast.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "lanes/complex_lanes.hpp"
#include "track/pads/pad_law.hpp"
#include "track/pads/pad_scale.hpp"
#include "track/statics/loaded_rail.hpp"

namespace railpem::track {

using lanes::Real;

namespace {

constexpr int kMostSteps = 15;  ///< 3 to 5 are usual from a near start

using Column = std::array<Real, 4>;  ///< of a symmetric band: the diagonal and three below it

Real larger(Real a, Real b) {
    return a > b ? a : b;
}
Real size(Real a) {
    return larger(a, -a);
}
double largest_lane(Real a) {
    double largest = a[0];
    for (int lane = 1; lane < lanes::width; ++lane) largest = std::max(largest, a[lane]);
    return largest;
}

/// F(S) and its slope, one compression per lane (pad_force, pad_stiffness).
struct ForcesAndSlopes {
    Real force_n{}, slope_n_per_m{};
};

ForcesAndSlopes curve_value(const PadCurve& curve, Real s) {
    ForcesAndSlopes value;
    if (curve.polynomial_n.empty()) {
        for (int lane = 0; lane < lanes::width; ++lane) {
            value.force_n[lane] = pad_force(curve, s[lane]);
            value.slope_n_per_m[lane] = pad_stiffness(curve, s[lane]);
        }
        return value;
    }
    for (auto c = curve.polynomial_n.rbegin(); c != curve.polynomial_n.rend(); ++c) {
        value.slope_n_per_m = value.slope_n_per_m * s + value.force_n;
        value.force_n = value.force_n * s + *c;
    }
    const auto beyond = s > lanes::broadcast(curve.limit_compression_m);
    const auto parted = s <= lanes::broadcast(curve.free_compression_m);
    const Real tangent = curve.limit_force_n + (s - curve.limit_compression_m) * curve.limit_stiffness_n_per_m;
    value.force_n = parted ? Real{} : beyond ? tangent : value.force_n;
    value.slope_n_per_m = parted   ? Real{}
                          : beyond ? lanes::broadcast(curve.limit_stiffness_n_per_m)
                                   : value.slope_n_per_m;
    return value;
}

/// What is iterated: deflections and rotations of the rail, compressions of the pads.
struct Shape {
    std::vector<Real> deflection, compression;
};

/// A seat near a deflection u and a compression S that need not belong together yet: its force on the rail and its
/// tangent once S follows u, and the step of S apart from what u adds, S + a·ρ·(F − F_c) = u linearised.
struct SeatStep {
    Real force_n, tangent_n_per_m, own_step_m, following;
    Real between_n;  ///< what pad and support disagree by
};

SeatStep seat_step(const SeatLaw& seat, Real scale, Real deflection, Real compression) {
    const ForcesAndSlopes pad = curve_value(seat.curve, compression);
    const Real force = scale * (pad.force_n - seat.clip_preload_n), slope = scale * pad.slope_n_per_m;
    const Real following = 1.0 / (1.0 + seat.support_compliance_m_per_n * slope);
    const Real own = (deflection - compression - seat.support_compliance_m_per_n * force) * following;
    return {force + slope * own, slope * following, own, following, size(slope * own)};
}

/// r = load − A·u for a band of one matrix that all lanes share.
void multiply_and_subtract(const LoadedRail& rail, const std::vector<Real>& u, std::vector<Real>& r) {
    const std::size_t n = u.size();
    for (std::size_t i = 0; i < n; ++i) r[i] = lanes::broadcast(rail.load[static_cast<Eigen::Index>(i)]);
    for (std::size_t i = 0; i < n; ++i) {
        const double* column = rail.stiffness.data() + 4 * i;
        r[i] -= column[0] * u[i];
        for (std::size_t k = 1; k < 4 && i + k < n; ++k) {
            r[i + k] -= column[k] * u[i];
            r[i] -= column[k] * u[i + k];
        }
    }
}

/// Solves matrix·x = b by LDLᵀ, x in place of b, the matrix destroyed.
void solve_abreast(std::vector<Column>& matrix, std::vector<Real>& x) {
    const std::size_t n = x.size();
    for (std::size_t i = 0; i + 1 < n; ++i) {
        Column& column = matrix[i];
        column[0] = 1.0 / column[0];
        const std::size_t reach = std::min<std::size_t>(3, n - 1 - i);
        for (std::size_t k = 1; k <= reach; ++k) {
            const Real factor = column[k] * column[0];
            for (std::size_t m = k; m <= reach; ++m) matrix[i + k][m - k] -= factor * column[m];
            x[i + k] -= factor * x[i];
        }
    }
    matrix[n - 1][0] = 1.0 / matrix[n - 1][0];
    for (std::size_t i = n; i-- > 0;) {
        const std::size_t reach = std::min<std::size_t>(3, n - 1 - i);
        Real value = x[i] * matrix[i][0];
        for (std::size_t k = 1; k <= reach; ++k) value -= matrix[i][k] * matrix[i][0] * x[i + k];
        x[i] = value;
    }
}

/// Up to lanes::width equilibria.
class Abreast {
  public:
    Abreast(const LoadedRail& rail, std::vector<Real> scale, double spacing_m)
        : rail_(rail),
          scale_(std::move(scale)),
          spacing_m_(spacing_m),
          seats_(scale_.size()),
          unbalanced_(static_cast<std::size_t>(rail.load.size())),
          tangent_(unbalanced_.size()) {}

    /// Newton's method on `shape`; the steps of the seats end up consistent. Per lane: whether it got there.
    std::array<bool, lanes::width> settle(Shape& shape) {
        const double tolerance = 1e-10 * rail_.largest_load_n;  // as the single equilibrium's
        Real left = residual(shape);
        for (int step = 0; step < kMostSteps && !(largest_lane(left) <= tolerance); ++step) {
            advance(shape);
            left = residual(shape);
        }
        // The compressions are one step behind the deflections.
        for (std::size_t j = 0; j < seats_.size(); ++j) shape.compression[j] += seats_[j].own_step_m;
        Real sum{};  // not a number if anything is
        for (const Real& u : shape.deflection) sum += u;
        std::array<bool, lanes::width> settled{};
        for (int lane = 0; lane < lanes::width; ++lane)
            settled[static_cast<std::size_t>(lane)] = left[lane] <= tolerance && std::isfinite(sum[lane]);
        return settled;
    }

  private:
    static std::size_t deflection(std::size_t pad) { return static_cast<std::size_t>(LoadedRail::deflection(pad)); }

    /// Largest unbalanced nodal load and unbalanced force between pad and support, N; moments count over half a bay.
    Real residual(const Shape& shape) {
        multiply_and_subtract(rail_, shape.deflection, unbalanced_);
        Real largest = larger(size(unbalanced_.front()), size(unbalanced_.back()));
        for (std::size_t j = 0; j < seats_.size(); ++j) {
            const std::size_t at = deflection(j);
            const SeatStep& seat = seats_[j] =
                seat_step(rail_.seat, scale_[j], shape.deflection[at], shape.compression[j]);
            unbalanced_[at] -= seat.force_n;
            largest = larger(larger(largest, seat.between_n),
                             larger(size(unbalanced_[at]), size(unbalanced_[at + 1]) * (2.0 / spacing_m_)));
        }
        return largest;
    }

    void advance(Shape& shape) {
        for (std::size_t i = 0; i < tangent_.size(); ++i)
            for (std::size_t k = 0; k < 4; ++k)
                tangent_[i][k] =
                    lanes::broadcast(rail_.stiffness(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)));
        for (std::size_t j = 0; j < seats_.size(); ++j) tangent_[deflection(j)][0] += seats_[j].tangent_n_per_m;
        solve_abreast(tangent_, unbalanced_);
        for (std::size_t i = 0; i < unbalanced_.size(); ++i) shape.deflection[i] += unbalanced_[i];
        for (std::size_t j = 0; j < seats_.size(); ++j)
            shape.compression[j] += seats_[j].own_step_m + seats_[j].following * unbalanced_[deflection(j)];
    }

    const LoadedRail& rail_;
    std::vector<Real> scale_;
    double spacing_m_;
    std::vector<SeatStep> seats_;
    std::vector<Real> unbalanced_;
    std::vector<Column> tangent_;
};

/// Seats of lanes::width tracks, per pad; tracks beyond the last repeat it.
std::vector<Real> scales(const TrackParameters& track, const std::vector<double>& wheels_m,
                         const std::vector<double>& pads_m, const std::vector<int>& first_seats, std::size_t first) {
    std::vector<Real> scale(pads_m.size());
    FailedFasteners failed = track.failed_fasteners.front();
    for (int lane = 0; lane < lanes::width; ++lane) {
        failed.first_seat = first_seats[std::min(first + static_cast<std::size_t>(lane), first_seats.size() - 1)];
        for (std::size_t j = 0; j < pads_m.size(); ++j)
            scale[j][lane] = pad_scale(failed, seat_index(track, wheels_m, pads_m[j]));
    }
    return scale;
}

/// Where the iteration begins: the unloaded track, or the equilibria given.
Shape begin(const SeatState& unloaded, std::size_t pads, const std::vector<StaticEquilibrium>& start,
            std::size_t first) {
    const std::size_t unknowns = 2 * pads + 2;
    Shape shape{std::vector<Real>(unknowns), std::vector<Real>(pads, lanes::broadcast(unloaded.compression_m))};
    shape.deflection.front() = shape.deflection.back() = lanes::broadcast(unloaded.displacement_m);
    for (std::size_t j = 0; j < pads; ++j)
        shape.deflection[static_cast<std::size_t>(LoadedRail::deflection(j))] =
            lanes::broadcast(unloaded.displacement_m);
    if (start.empty()) return shape;
    for (int lane = 0; lane < lanes::width; ++lane) {
        const StaticEquilibrium& near = start[std::min(first + static_cast<std::size_t>(lane), start.size() - 1)];
        if (near.deflection.size() != unknowns || near.compression_m.size() != pads) continue;
        for (std::size_t i = 0; i < unknowns; ++i) shape.deflection[i][lane] = near.deflection[i];
        for (std::size_t j = 0; j < pads; ++j) shape.compression[j][lane] = near.compression_m[j];
    }
    return shape;
}

/// One lane as what static_equilibrium() returns.
StaticEquilibrium equilibrium_of(const TrackParameters& track, const LoadedRail& rail,
                                 const std::vector<double>& pads_m, const SeatState& unloaded, const Shape& shape,
                                 const std::vector<Real>& scale, int lane) {
    StaticEquilibrium result;
    result.position_m = pads_m;
    for (const Real& u : shape.deflection) result.deflection.push_back(u[lane]);
    for (std::size_t j = 0; j < pads_m.size(); ++j) {
        result.remaining_fraction.push_back(scale[j][lane]);
        result.compression_m.push_back(shape.compression[j][lane]);
        result.static_stiffness_n_per_m.push_back(pad_stiffness(rail.seat.curve, shape.compression[j][lane]));
        result.dynamic_stiffness_n_per_m.push_back(
            initial_dynamic_stiffness(track.pads, result.static_stiffness_n_per_m.back()));
    }
    result.unloaded_compression_m = unloaded.compression_m;
    result.unloaded_static_stiffness_n_per_m = pad_stiffness(rail.seat.curve, unloaded.compression_m);
    result.unloaded_dynamic_stiffness_n_per_m =
        initial_dynamic_stiffness(track.pads, result.unloaded_static_stiffness_n_per_m);
    return result;
}

}  // namespace

std::vector<StaticEquilibrium> equilibria_abreast(const TrackParameters& track, const std::vector<double>& wheels_m,
                                                  double wheel_load_n, const std::vector<double>& pads_m,
                                                  const std::vector<int>& first_seats,
                                                  const std::vector<StaticEquilibrium>& start) {
    assert(!track.failed_fasteners.empty() && (start.empty() || start.size() == first_seats.size()));
    const LoadedRail rail = loaded_rail(track, wheels_m, wheel_load_n, pads_m);
    const SeatState unloaded = unloaded_seat(rail.seat, rest_load_n(track));
    std::vector<StaticEquilibrium> result;
    for (std::size_t first = 0; first < first_seats.size(); first += lanes::width) {
        const std::vector<Real> scale = scales(track, wheels_m, pads_m, first_seats, first);
        Shape shape = begin(unloaded, pads_m.size(), start, first);
        const auto settled = Abreast(rail, scale, track.spacing_m).settle(shape);
        for (std::size_t lane = 0; lane < lanes::width && first + lane < first_seats.size(); ++lane) {
            if (settled[lane]) {
                result.push_back(equilibrium_of(track, rail, pads_m, unloaded, shape, scale, static_cast<int>(lane)));
                continue;
            }
            TrackParameters alone = track;
            alone.failed_fasteners.front().first_seat = first_seats[first + lane];
            result.push_back(static_equilibrium(alone, wheels_m, wheel_load_n, pads_m));
        }
    }
    return result;
}

}  // namespace railpem::track

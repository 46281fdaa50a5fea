#include "track/pads/pad_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "lanes/complex_lanes.hpp"
#include "parameters/parameter_error.hpp"

namespace railpem::track {

using parameters::ParameterError;

namespace {

struct ForceAndSlope {
    double force_n, slope_n_per_m;
};

ForceAndSlope polynomial_value(const std::vector<double>& coefficients, double s) {
    ForceAndSlope value{0.0, 0.0};
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) {
        value.slope_n_per_m = value.slope_n_per_m * s + value.force_n;
        value.force_n = value.force_n * s + *c;
    }
    return value;
}

ForceAndSlope piece_value(const CurvePiece& piece, double s) {
    const double t = s - piece.from_m;
    return {piece.c0 + t * (piece.c1 + t * (piece.c2 + t * piece.c3)),
            piece.c1 + t * (2.0 * piece.c2 + t * 3.0 * piece.c3)};
}

/// The formula of the curve, without its ends.
ForceAndSlope measured_value(const PadCurve& curve, double s) {
    if (!curve.polynomial_n.empty()) return polynomial_value(curve.polynomial_n, s);
    assert(!curve.pieces.empty());
    const auto after = std::upper_bound(curve.pieces.begin(), curve.pieces.end(), s,
                                        [](double x, const CurvePiece& piece) { return x < piece.from_m; });
    return piece_value(after == curve.pieces.begin() ? curve.pieces.front() : *(after - 1), s);
}

/// The compression in [low, high] at which the measured curve, rising there, has the given force.
double bisect(const PadCurve& curve, double low, double high, double force_n) {
    if (measured_value(curve, low).force_n >= force_n) return low;
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) return high;
        (measured_value(curve, middle).force_n < force_n ? low : high) = middle;
    }
}

/// The same by Newton's method, within the bracket that every value narrows: a tenth of the evaluations.
double compression_at(const PadCurve& curve, double low, double high, double force_n) {
    double s = low + (high - low) * force_n / curve.limit_force_n;
    for (;;) {
        const ForceAndSlope value = measured_value(curve, s);
        (value.force_n < force_n ? low : high) = s;
        double next = s - (value.force_n - force_n) / value.slope_n_per_m;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (std::abs(next - s) <= 4.0 * std::numeric_limits<double>::epsilon() * std::abs(s) || next <= low ||
            next >= high)
            return next;
        s = next;
    }
}

[[noreturn]] void refuse_falling_curve(double compression_m, double force_n) {
    throw ParameterError("track.pads.force_polynomial_n",
                         fmt::format("the static curve stops rising at a compression of {:.3g} mm, at {:.3g} kN",
                                     1e3 * compression_m, 1e-3 * force_n),
                         "a curve that rises up to curve_limit_n, or a smaller curve_limit_n");
}

/// The first step from the free compression at which a polynomial is not below the limit, several at once: the steps
/// are many, and a train at many places asks for the curve at each.
double first_beyond(const PadCurve& curve, double limit_n, double step, double farthest) {
    for (double s = curve.free_compression_m;;) {
        lanes::Real at{}, force{}, slope{};
        for (int lane = 0; lane < lanes::width; ++lane, s += step) at[lane] = s;
        for (auto c = curve.polynomial_n.rbegin(); c != curve.polynomial_n.rend(); ++c) {
            slope = slope * at + force;
            force = force * at + *c;
        }
        for (int lane = 0; lane < lanes::width; ++lane) {
            if (!(force[lane] < limit_n)) return at[lane];
            if (slope[lane] <= 0.0 || at[lane] - curve.free_compression_m > farthest)
                refuse_falling_curve(at[lane], force[lane]);
        }
    }
}

/// Walks along a polynomial in steps far below any compression of interest: from zero force up to the limit, making
/// sure that it rises all the way.
void find_polynomial_ends(PadCurve& curve, const PadParameters& pads) {
    const double range = pads.curve_limit_n / pads.static_stiffness_n_per_m;  // about the compression at the limit
    const double step = range / 1000.0;
    const double farthest = 20.0 * range;
    const auto force = [&](double s) { return measured_value(curve, s).force_n; };
    const bool upwards = force(0.0) <= 0.0;
    double s = 0.0;
    while (upwards ? force(s + step) <= 0.0 : force(s) > 0.0) {
        s += upwards ? step : -step;
        if (std::abs(s) > farthest)
            throw ParameterError("track.pads.force_polynomial_n", "the static curve never passes through zero force",
                                 "a curve that starts near F = 0 and rises");
    }
    curve.free_compression_m = bisect(curve, s, s + step, 0.0);
    s = first_beyond(curve, pads.curve_limit_n, step, farthest);
    const double before = std::max(s - step, curve.free_compression_m);
    curve.limit_compression_m = bisect(curve, before, s, pads.curve_limit_n);
}

/// Slopes of the monotone cubic at the points: weighted harmonic means of the neighbouring secants (Fritsch & Butland);
/// at the ends the three-point formula, kept between the bounds that monotonicity sets and above zero.
std::vector<double> monotone_slopes(const std::vector<double>& s, const std::vector<double>& force) {
    const std::size_t n = s.size();
    assert(n >= 3);
    std::vector<double> secant(n - 1), h(n - 1), slope(n);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        h[i] = s[i + 1] - s[i];
        secant[i] = (force[i + 1] - force[i]) / h[i];
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double w1 = 2.0 * h[i] + h[i - 1], w2 = h[i] + 2.0 * h[i - 1];
        slope[i] = (w1 + w2) / (w1 / secant[i - 1] + w2 / secant[i]);
    }
    const auto end = [](double h1, double h2, double d1, double d2) {
        const double three_point = ((2.0 * h1 + h2) * d1 - h1 * d2) / (h1 + h2);
        return three_point > 0.0 ? std::min(three_point, 3.0 * d1) : d1;
    };
    slope[0] = end(h[0], h[1], secant[0], secant[1]);
    slope[n - 1] = end(h[n - 2], h[n - 3], secant[n - 2], secant[n - 3]);
    return slope;
}

PadCurve curve_from_points(const PadParameters& pads) {
    const std::vector<double>&s = pads.curve_compression_m, &force = pads.curve_force_n;
    if (force.front() >= pads.curve_limit_n)
        throw ParameterError("track.pads.curve_limit_n", "the static curve begins above its limit",
                             fmt::format("more than {:g} N", force.front()));
    if (force.back() <= 0.0)
        throw ParameterError("track.pads.curve_force_n", "the static curve never passes through zero force",
                             "forces that reach above 0");
    const std::vector<double> slope = monotone_slopes(s, force);
    PadCurve curve;
    if (force.front() > 0.0) {
        curve.free_compression_m = s.front() - force.front() / slope.front();
        curve.pieces.push_back({curve.free_compression_m, 0.0, slope.front(), 0.0, 0.0});
    }
    for (std::size_t i = 0; i + 1 < s.size(); ++i) {
        const double h = s[i + 1] - s[i], secant = (force[i + 1] - force[i]) / h;
        curve.pieces.push_back({s[i], force[i], slope[i], (3.0 * secant - 2.0 * slope[i] - slope[i + 1]) / h,
                                (slope[i] + slope[i + 1] - 2.0 * secant) / (h * h)});
    }
    if (force.front() <= 0.0) curve.free_compression_m = bisect(curve, s.front(), s.back(), 0.0);
    const bool cut = pads.curve_limit_n < force.back();
    curve.limit_compression_m = cut ? bisect(curve, s.front(), s.back(), pads.curve_limit_n) : s.back();
    return curve;
}

}  // namespace

PadCurve pad_curve(const PadParameters& pads) {
    assert(pads.static_stiffness_n_per_m > 0.0);
    PadCurve curve;
    if (!pads.curve_force_n.empty()) {
        curve = curve_from_points(pads);
    } else if (!pads.force_polynomial_n.empty()) {
        curve.polynomial_n = pads.force_polynomial_n;
        find_polynomial_ends(curve, pads);
    } else {
        curve.polynomial_n = {0.0, pads.static_stiffness_n_per_m};
        return curve;
    }
    const ForceAndSlope limit = measured_value(curve, curve.limit_compression_m);
    curve.limit_force_n = limit.force_n;
    curve.limit_stiffness_n_per_m = limit.slope_n_per_m;
    return curve;
}

double pad_force(const PadCurve& curve, double compression_m) {
    if (compression_m <= curve.free_compression_m) return 0.0;
    if (compression_m > curve.limit_compression_m)
        return curve.limit_force_n + curve.limit_stiffness_n_per_m * (compression_m - curve.limit_compression_m);
    return measured_value(curve, compression_m).force_n;
}

double pad_force(const PadCurve& curve, double compression_m, std::size_t& piece) {
    if (curve.pieces.empty() || compression_m <= curve.free_compression_m || compression_m > curve.limit_compression_m)
        return pad_force(curve, compression_m);
    piece = std::min(piece, curve.pieces.size() - 1);
    while (piece > 0 && compression_m < curve.pieces[piece].from_m) --piece;
    while (piece + 1 < curve.pieces.size() && compression_m >= curve.pieces[piece + 1].from_m) ++piece;
    return piece_value(curve.pieces[piece], compression_m).force_n;
}

double pad_stiffness(const PadCurve& curve, double compression_m) {
    if (compression_m <= curve.free_compression_m) return 0.0;
    if (compression_m > curve.limit_compression_m) return curve.limit_stiffness_n_per_m;
    return measured_value(curve, compression_m).slope_n_per_m;
}

double pad_compression(const PadCurve& curve, double force_n) {
    if (force_n <= 0.0) return curve.free_compression_m;
    if (force_n > curve.limit_force_n)
        return curve.limit_compression_m + (force_n - curve.limit_force_n) / curve.limit_stiffness_n_per_m;
    if (std::isinf(curve.limit_compression_m)) return force_n / curve.polynomial_n[1];
    return compression_at(curve, curve.free_compression_m, curve.limit_compression_m, force_n);
}

}  // namespace railpem::track

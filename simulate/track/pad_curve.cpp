#include "simulate/track/pad_curve.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "parameters/parameter_error.hpp"

namespace railpem::simulate {

namespace {

// Compressions met in service lie well inside; 10 µm keeps the cubic's error below 1e-9 of the force for F(S) of
// degree 4.
constexpr double lowest_m = -4e-3;
constexpr double highest_m = 16e-3;
constexpr double spacing_m = 10e-6;

double polynomial(const std::vector<double>& coefficients, double s) {
    double value = 0.0;
    for (std::size_t i = coefficients.size(); i-- > 0;) value = value * s + coefficients[i];
    return value;
}

double polynomial_slope(const std::vector<double>& coefficients, double s) {
    double value = 0.0;
    for (std::size_t i = coefficients.size(); i-- > 1;) value = value * s + static_cast<double>(i) * coefficients[i];
    return value;
}

/// Slopes of the monotone cubic through points (Fritsch & Butland 1984: weighted harmonic mean inside, secant at the
/// ends).
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y) {
    const std::size_t n = x.size();
    const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
    std::vector<double> slope(n);
    slope.front() = secant(0);
    slope.back() = secant(n - 2);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = x[i] - x[i - 1];
        const double after = x[i + 1] - x[i];
        slope[i] =
            3.0 * (before + after) / ((2.0 * after + before) / secant(i - 1) + (after + 2.0 * before) / secant(i));
    }
    return slope;
}

/// Tangent stiffness dF/dS against the load F: what preload does to a pad. Monotone tables over S from 0 on.
struct StaticLaw {
    std::vector<double> compression_m, force_n, tangent_n_per_m;

    double at_force(const std::vector<double>& column, double force) const {
        if (force <= force_n.front()) return column.front();
        if (force >= force_n.back()) return column.back();
        const auto i =
            static_cast<std::size_t>(std::upper_bound(force_n.begin(), force_n.end(), force) - force_n.begin());
        const double share = (force - force_n[i - 1]) / (force_n[i] - force_n[i - 1]);
        return column[i - 1] + share * (column[i] - column[i - 1]);
    }
    double tangent(double force) const { return at_force(tangent_n_per_m, force); }
};

StaticLaw static_law(const track::PadParameters& pads) {
    StaticLaw law;
    std::vector<double> slopes;
    if (!pads.curve_force_n.empty()) slopes = monotone_slopes(pads.curve_compression_m, pads.curve_force_n);
    const double limit = pads.curve_limit_n;
    for (double s = 0.0; s < 0.05; s += 2e-6) {
        double force = 0.0;
        double tangent = 0.0;
        if (slopes.empty()) {
            force = polynomial(pads.force_polynomial_n, s);
            tangent = polynomial_slope(pads.force_polynomial_n, s);
        } else {
            const std::vector<double>& x = pads.curve_compression_m;
            const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
                std::upper_bound(x.begin(), x.end(), s) - x.begin(), 1, std::ptrdiff_t(x.size()) - 1));
            const double h = x[i] - x[i - 1];
            const double t = std::clamp((s - x[i - 1]) / h, 0.0, 1.0);
            const double rise = pads.curve_force_n[i] - pads.curve_force_n[i - 1];
            tangent = slopes[i - 1] * (1 - 4 * t + 3 * t * t) + slopes[i] * (3 * t * t - 2 * t) +
                      6.0 * t * (1 - t) * rise / h;
            force = pads.curve_force_n[i - 1] +
                    h * (slopes[i - 1] * t * (1 - t) * (1 - t) + slopes[i] * t * t * (t - 1)) +
                    rise * t * t * (3 - 2 * t);
        }
        if (!law.force_n.empty() && (force <= law.force_n.back() || tangent <= 0.0)) continue;
        law.compression_m.push_back(s);
        law.force_n.push_back(force);
        law.tangent_n_per_m.push_back(tangent);
        if (force > limit) break;
    }
    if (law.force_n.size() < 3)
        throw parameters::ParameterError("track.pads.force_polynomial_n", "the static curve of the pad does not rise",
                                         "a force that grows with the compression");
    return law;
}

/// Integrates dF/dx = tangent(F) from F(0) = 0 both ways by the classical Runge–Kutta method.
PadCurve integrate(const std::function<double(double)>& tangent) {
    const auto below = static_cast<std::size_t>(std::lround(-lowest_m / spacing_m));
    const auto above = static_cast<std::size_t>(std::lround(highest_m / spacing_m));
    PadCurve curve{.first_m = -spacing_m * static_cast<double>(below), .step_m = spacing_m};
    curve.force_n.assign(below + above + 1, 0.0);
    const auto advanced = [&](double force, double h) {
        const double k1 = tangent(force);
        const double k2 = tangent(force + 0.5 * h * k1);
        const double k3 = tangent(force + 0.5 * h * k2);
        const double k4 = tangent(force + h * k3);
        return force + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    };
    for (std::size_t i = below; i < below + above; ++i) curve.force_n[i + 1] = advanced(curve.force_n[i], spacing_m);
    for (std::size_t i = below; i > 0; --i) curve.force_n[i - 1] = advanced(curve.force_n[i], -spacing_m);
    for (const double force : curve.force_n) curve.tangent_n_per_m.push_back(tangent(force));
    return curve;
}

double unloaded_force(const track::TrackParameters& track) {
    const double mass =
        track.statics.rail_weight_kg_per_m > 0.0 ? track.statics.rail_weight_kg_per_m : track.rail.mass_kg_per_m;
    return track.statics.clip_preload_n + mass * track.statics.gravity_m_per_s2 * track.spacing_m;
}

/// The curve with a soft stretch inserted where the play's load is reached, smooth over its ends.
PadCurve with_dead_band(const PadCurve& curve, const PadDeadBand& play) {
    const double width = play.gap_m;
    if (width <= 0.0) return curve;
    const double start = curve.compression(play.at_load_n);
    constexpr double left_in_band = 0.1;
    PadCurve with = curve;
    const auto share = [&](double x) {  // of the stiffness that acts at x
        const double into = x - start;
        const double blend = std::clamp(std::min(into, width - into) / (0.1 * width), 0.0, 1.0);
        return 1.0 - (1.0 - left_in_band) * blend * blend * (3.0 - 2.0 * blend);
    };
    double inner = curve.first_m;  // compression of the pad proper
    for (std::size_t i = 0; i < with.force_n.size(); ++i) {
        const double x = curve.first_m + curve.step_m * static_cast<double>(i);
        with.force_n[i] = curve.force(inner);
        with.tangent_n_per_m[i] = curve.tangent(inner) * share(x);
        inner += curve.step_m * share(x + 0.5 * curve.step_m);
    }
    return with;
}

}  // namespace

bool is_nonlinear(const track::PadParameters& pads, const PadDeadBand& play) {
    return pads.preload_strength > 0.0 || play.gap_m > 0.0;
}

double PadCurve::force(double x) const {
    const double place = (x - first_m) / step_m;
    const auto last = static_cast<double>(force_n.size() - 1);
    if (place <= 0.0) return force_n.front() + (x - first_m) * tangent_n_per_m.front();
    if (place >= last) return force_n.back() + (place - last) * step_m * tangent_n_per_m.back();
    const auto i = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(i);
    const double rise = force_n[i + 1] - force_n[i];
    return force_n[i] +
           step_m * (tangent_n_per_m[i] * t * (1 - t) * (1 - t) + tangent_n_per_m[i + 1] * t * t * (t - 1)) +
           rise * t * t * (3 - 2 * t);
}

double PadCurve::tangent(double x) const {
    const double place = std::clamp((x - first_m) / step_m, 0.0, static_cast<double>(force_n.size() - 1) - 1e-9);
    const auto i = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(i);
    return tangent_n_per_m[i] + t * (tangent_n_per_m[i + 1] - tangent_n_per_m[i]);
}

double PadCurve::compression(double force_sought) const {
    if (force_sought <= force_n.front()) return first_m + (force_sought - force_n.front()) / tangent_n_per_m.front();
    const double end = first_m + step_m * static_cast<double>(force_n.size() - 1);
    if (force_sought >= force_n.back()) return end + (force_sought - force_n.back()) / tangent_n_per_m.back();
    const auto i =
        static_cast<std::size_t>(std::upper_bound(force_n.begin(), force_n.end(), force_sought) - force_n.begin());
    double x = first_m +
               step_m * (static_cast<double>(i - 1) + (force_sought - force_n[i - 1]) / (force_n[i] - force_n[i - 1]));
    for (int pass = 0; pass < 3; ++pass) x += (force_sought - force(x)) / tangent(x);
    return x;
}

PadCurve static_curve(const track::TrackParameters& track, const PadDeadBand& play) {
    const track::PadParameters& pads = track.pads;
    if (pads.preload_strength <= 0.0)
        return with_dead_band(integrate([&](double) { return pads.static_stiffness_n_per_m; }), play);
    const StaticLaw law = static_law(pads);
    const double unloaded = unloaded_force(track);
    return with_dead_band(integrate([&](double force) { return law.tangent(unloaded + force); }), play);
}

PadCurve dynamic_curve(const track::TrackParameters& track, const PadDeadBand& play) {
    const track::PadParameters& pads = track.pads;
    const double ratio = pads.dynamic_to_static_ratio;
    const double s = pads.preload_strength;
    if (s <= 0.0) return with_dead_band(integrate([&](double) { return ratio * pads.static_stiffness_n_per_m; }), play);
    const StaticLaw law = static_law(pads);
    const double unloaded = unloaded_force(track);
    return with_dead_band(integrate([&](double force) {
                              return ratio *
                                     ((1.0 - s) * pads.static_stiffness_n_per_m + s * law.tangent(unloaded + force));
                          }),
                          play);
}

}  // namespace railpem::simulate

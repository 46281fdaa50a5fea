#include "simulate/march/travel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate/numerics/random_numbers.hpp"
#include "simulate/numerics/smooth_noise.hpp"

namespace railpem::simulate {

namespace {

using std::numbers::pi;

// Purposes of derived seeds.
constexpr std::uint64_t for_wander = 2;
constexpr std::uint64_t for_speed = 301;

std::vector<Travel::Wave> draw_wander(double relative_fluctuation, std::uint64_t seed) {
    std::vector<Travel::Wave> wander;
    if (relative_fluctuation <= 0.0) return wander;
    constexpr int waves = 6;
    const std::uint64_t own = derived_seed(seed, for_wander);
    for (int i = 0; i < waves; ++i) {
        const double period =
            15.0 * std::pow(80.0 / 15.0, (i + uniform_at(own, 2 * static_cast<std::uint64_t>(i))) / waves);
        wander.push_back({relative_fluctuation * std::sqrt(2.0 / waves), 1.0 / period,
                          2.0 * pi * uniform_at(own, 2 * static_cast<std::uint64_t>(i) + 1)});
    }
    return wander;
}

/// Linear between the rows, constant beyond them.
double at(const SpeedTable& table, double time_s) {
    const std::vector<double>& t = table.time_s;
    if (time_s <= t.front()) return table.speed_m_per_s.front();
    if (time_s >= t.back()) return table.speed_m_per_s.back();
    const auto above = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), time_s) - t.begin());
    const double share = (time_s - t[above - 1]) / (t[above] - t[above - 1]);
    return table.speed_m_per_s[above - 1] + share * (table.speed_m_per_s[above] - table.speed_m_per_s[above - 1]);
}

/// What the driver holds, before anything random.
double intended_speed(double speed_m_per_s, const Options& options, double time_s) {
    if (options.speed_table) return at(*options.speed_table, time_s);
    const double end = options.world.speed_end_m_per_s;
    if (end <= 0.0) return speed_m_per_s;
    return speed_m_per_s + (end - speed_m_per_s) * std::clamp(time_s / options.seconds, 0.0, 1.0);
}

void set_slopes(SpeedCurve& curve) {
    const std::vector<double>& v = curve.speed_m_per_s;
    curve.acceleration_m_per_s2.assign(v.size(), 0.0);
    for (std::size_t i = 1; i + 1 < v.size(); ++i) {
        const double before = (v[i] - v[i - 1]) / curve.step_s;
        const double behind = (v[i + 1] - v[i]) / curve.step_s;
        if (before * behind > 0.0) curve.acceleration_m_per_s2[i] = 2.0 * before * behind / (before + behind);
    }
}

/// Way within one interval, u of it gone: the integral of Hermite's cubic.
double way_within(const SpeedCurve& curve, std::size_t i, double u) {
    const double u2 = u * u, u3 = u2 * u, u4 = u2 * u2, h = curve.step_s;
    return h * (curve.speed_m_per_s[i] * (u - u3 + 0.5 * u4) + curve.speed_m_per_s[i + 1] * (u3 - 0.5 * u4) +
                h * curve.acceleration_m_per_s2[i] * (0.5 * u2 - 2.0 / 3.0 * u3 + 0.25 * u4) +
                h * curve.acceleration_m_per_s2[i + 1] * (0.25 * u4 - u3 / 3.0));
}

void integrate(SpeedCurve& curve) {
    curve.distance_m.assign(curve.speed_m_per_s.size(), 0.0);
    for (std::size_t i = 0; i + 1 < curve.distance_m.size(); ++i)
        curve.distance_m[i + 1] = curve.distance_m[i] + way_within(curve, i, 1.0);
    const double origin = curve.distance(0.0);
    for (double& distance : curve.distance_m) distance -= origin;
}

double relative_wander(const std::vector<Travel::Wave>& wander, double time_s) {
    double sum = 0.0;
    for (const Travel::Wave& wave : wander)
        sum += wave.amplitude * std::sin(2.0 * pi * wave.frequency_hz * time_s + wave.phase);
    return sum;
}

}  // namespace

double SpeedCurve::distance(double time_s) const {
    const double place = (time_s - first_s) / step_s;
    const auto last = static_cast<double>(speed_m_per_s.size() - 1);
    if (place <= 0.0) return distance_m.front() + place * step_s * speed_m_per_s.front();
    if (place >= last) return distance_m.back() + (place - last) * step_s * speed_m_per_s.back();
    const auto i = static_cast<std::size_t>(place);
    return distance_m[i] + way_within(*this, i, place - static_cast<double>(i));
}

double SpeedCurve::speed(double time_s) const {
    const double place = (time_s - first_s) / step_s;
    const auto last = static_cast<double>(speed_m_per_s.size() - 1);
    if (place <= 0.0) return speed_m_per_s.front();
    if (place >= last) return speed_m_per_s.back();
    const auto i = static_cast<std::size_t>(place);
    const double u = place - static_cast<double>(i), u2 = u * u, u3 = u2 * u;
    return speed_m_per_s[i] * (2.0 * u3 - 3.0 * u2 + 1.0) + speed_m_per_s[i + 1] * (3.0 * u2 - 2.0 * u3) +
           step_s * (acceleration_m_per_s2[i] * (u3 - 2.0 * u2 + u) + acceleration_m_per_s2[i + 1] * (u3 - u2));
}

double Travel::distance(double time_s) const {
    if (!curve.speed_m_per_s.empty()) return curve.distance(time_s);
    double time = time_s;
    for (const Wave& wave : wander) {
        const double omega = 2.0 * pi * wave.frequency_hz;
        time += wave.amplitude / omega * (std::cos(wave.phase) - std::cos(omega * time_s + wave.phase));
    }
    return speed_m_per_s * time;
}

double Travel::speed(double time_s) const {
    return curve.speed_m_per_s.empty() ? speed_m_per_s * (1.0 + relative_wander(wander, time_s)) : curve.speed(time_s);
}

Travel make_travel(double speed_m_per_s, const Options& options, double start_s, double end_s) {
    const WorldParameters& world = options.world;
    Travel travel{.speed_m_per_s = speed_m_per_s, .wander = draw_wander(options.speed_fluctuation, options.seed)};
    if (world.speed_rms <= 0.0 && world.speed_end_m_per_s <= 0.0 && !options.speed_table) return travel;
    constexpr double step_s = 0.05;  // far below what a train's speed can do
    const std::uint64_t seed = derived_seed(options.seed, for_speed);
    const double first = std::floor(start_s / step_s) - 1.0;
    SpeedCurve& curve = travel.curve;
    curve.first_s = first * step_s;
    curve.step_s = step_s;
    for (double k = first; k * step_s < end_s + 2.0 * step_s; ++k) {
        const double time = k * step_s;
        double relative = 1.0 + relative_wander(travel.wander, time);
        if (world.speed_rms > 0.0) relative += world.speed_rms * smooth_noise_at(seed, time, world.speed_correlation_s);
        curve.speed_m_per_s.push_back(intended_speed(speed_m_per_s, options, time) * std::max(0.0, relative));
    }
    set_slopes(curve);
    integrate(curve);
    return travel;
}

double highest_speed_m_per_s(const Travel& travel) {
    const std::vector<double>& speeds = travel.curve.speed_m_per_s;
    return speeds.empty() ? travel.speed_m_per_s : *std::max_element(speeds.begin(), speeds.end());
}

void describe_travel(const Travel& travel, double seconds, WorldDraws& draws) {
    constexpr double step_s = 0.02;
    const auto count = static_cast<std::size_t>(std::ceil(seconds / step_s));
    draws.mean_speed_m_per_s = travel.distance(seconds) / seconds;
    draws.least_speed_m_per_s = draws.most_speed_m_per_s = travel.speed(0.0);
    double squares = 0.0;
    for (std::size_t i = 0; i <= count; ++i) {
        const double speed = travel.speed(std::min(seconds, static_cast<double>(i) * step_s));
        draws.least_speed_m_per_s = std::min(draws.least_speed_m_per_s, speed);
        draws.most_speed_m_per_s = std::max(draws.most_speed_m_per_s, speed);
        squares += (speed - draws.mean_speed_m_per_s) * (speed - draws.mean_speed_m_per_s);
    }
    draws.speed_rms_m_per_s = std::sqrt(squares / static_cast<double>(count + 1));
}

}  // namespace railpem::simulate

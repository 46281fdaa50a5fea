#include "recordings/estimates/running_speed.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/estimates/fourier_transform.hpp"
#include "recordings/estimates/interpolation.hpp"
#include "recordings/estimates/speed_grid.hpp"
#include "recordings/estimates/window.hpp"

namespace railpem::recordings {

namespace {

using Complex = std::complex<double>;
constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// Two channels that meet the same track, places in m from the centre of the body.
struct SpeedPair {
    std::size_t front = 0, rear = 0;
    double front_m = 0.0, rear_m = 0.0;
    double distance_m() const { return front_m - rear_m; }
};

std::vector<SpeedPair> speed_pairs(const TimeSeries& series, const VehicleGeometry& geometry) {
    std::vector<SpeedPair> all;
    double longest = 0.0;
    for (std::size_t i = 0; i < series.channels.size(); ++i)
        for (std::size_t j = 0; j < series.channels.size(); ++j) {
            const ChannelDescription &a = series.channels[i].description, &b = series.channels[j].description;
            const auto distance = distance_between(a, b, geometry);
            if (!distance || *distance <= 0.0 || a.location != b.location || a.quantity != b.quantity) continue;
            if (a.side != b.side && a.side != Side::unstated && b.side != Side::unstated) continue;
            const double front = *place_along(a, geometry);
            all.push_back({i, j, front, front - *distance});
            longest = std::max(longest, *distance);
        }
    std::erase_if(all, [&](const SpeedPair& pair) { return pair.distance_m() < 0.5 * longest; });
    return all;
}

std::vector<std::vector<double>> filled(const TimeSeries& series) {
    std::vector<std::vector<double>> samples;
    for (const Channel& channel : series.channels) {
        samples.push_back(without_trend(channel.samples));
        for (double& value : samples.back())
            if (!std::isfinite(value)) value = 0.0;  // a gap only lowers the correlation
    }
    return samples;
}

/// Whitened cross-correlation of a window of the front channel with what the rear one shows after it, by speed.
void add_correlation(const std::vector<double>& front, const std::vector<double>& rear, std::size_t begin,
                     std::size_t length, double rate, double distance_m, const SpeedGrid& grid,
                     const RunningSpeedOptions& options, std::vector<double>& score) {
    const auto reach = static_cast<std::size_t>(distance_m / grid.at(0) * rate) + 2;
    const FourierTransform transform(fast_length(length + reach));
    std::vector<double> a(transform.length(), 0.0), b(transform.length(), 0.0);
    for (std::size_t i = 0; i < length && begin + i < front.size(); ++i) a[i] = front[begin + i];
    for (std::size_t i = 0; i < length + reach && begin + i < rear.size(); ++i) b[i] = rear[begin + i];
    std::vector<Complex> fa(transform.bins()), fb(transform.bins());
    transform.forward(a.data(), fa.data());
    transform.forward(b.data(), fb.data());
    const double bin = rate / static_cast<double>(transform.length());
    for (std::size_t k = 0; k < fa.size(); ++k) {
        const double f = static_cast<double>(k) * bin, power = std::abs(fa[k]) * std::abs(fb[k]);
        const bool used = f >= options.from_hz && f <= std::min(options.to_hz, 0.4 * rate) && power > 0.0;
        fa[k] = used ? std::conj(fa[k]) * fb[k] / power : Complex(0.0);
    }
    std::vector<double> correlation(transform.length());
    transform.inverse(fa.data(), correlation.data());
    for (std::size_t i = 0; i < grid.count; ++i) {
        const double lag = distance_m / grid.at(i) * rate;
        const auto at = static_cast<std::size_t>(lag);
        const double share = lag - std::floor(lag);
        score[i] += (1.0 - share) * correlation[at] + share * correlation[at + 1];
    }
}

/// Means over Hann weights that reach half a window to either side: what is faster no window can tell.
std::vector<double> smoothed(const std::vector<double>& values, const RunningSpeedOptions& options) {
    const auto reach = static_cast<long>(0.5 * options.window_s / options.hop_s);
    std::vector<double> smooth;
    for (long i = 0; i < static_cast<long>(values.size()); ++i) {
        double sum = 0.0, weights = 0.0;
        for (long k = std::max(0L, i - reach); k <= std::min(i + reach, static_cast<long>(values.size()) - 1); ++k) {
            const double own =
                0.5 + 0.5 * std::cos(std::numbers::pi * static_cast<double>(k - i) / static_cast<double>(reach + 1));
            sum += own * values[static_cast<std::size_t>(k)];
            weights += own;
        }
        smooth.push_back(sum / weights);
    }
    return smooth;
}

/// The path through speeds at times, straight on to the ends of the record as over the window beside them.
TrackPath path_through(std::vector<double> time, std::vector<double> speed, double end_s,
                       const RunningSpeedOptions& options) {
    const auto reach = std::min(time.size() - 1, static_cast<std::size_t>(options.window_s / options.hop_s));
    if (reach > 0) {
        const std::size_t last = time.size() - 1;
        const double begin = (speed[reach] - speed[0]) / (time[reach] - time[0]),
                     end = (speed[last] - speed[last - reach]) / (time[last] - time[last - reach]);
        time.push_back(end_s);
        speed.push_back(std::max(0.5 * speed[last], speed[last] + end * (end_s - time[last])));
        speed.insert(speed.begin(), std::max(0.5 * speed[0], speed[0] - begin * time[0]));
        time.insert(time.begin(), 0.0);
    }
    return track_path(time, speed, options.hop_s, end_s);
}

/// First look: which speed each window has, to the grid's step.
TrackPath first_path(const std::vector<std::vector<double>>& samples, const std::vector<SpeedPair>& pairs, double rate,
                     double expected, const RunningSpeedOptions& options) {
    constexpr double kStep = 0.004;  // relative: a quarter of what 90 Hz resolve over 18 m at 25 m/s
    const SpeedGrid grid = speed_grid(expected * (1.0 - options.search), expected * (1.0 + options.search), kStep);
    const auto length = static_cast<std::size_t>(options.first_window_s * rate),
               hop = static_cast<std::size_t>(options.hop_s * rate);
    std::vector<std::vector<double>> score;
    for (std::size_t begin = 0; begin + length <= samples.front().size(); begin += hop) {
        score.emplace_back(grid.count, 0.0);
        for (const SpeedPair& pair : pairs)
            add_correlation(samples[pair.front], samples[pair.rear], begin, length, rate, pair.distance_m(), grid,
                            options, score.back());
    }
    const auto most = static_cast<std::size_t>(std::ceil(options.most_acceleration * options.hop_s / expected / kStep));
    const std::vector<std::size_t> path = best_path(score, most);
    std::vector<double> time, speed;
    for (std::size_t w = 0; w < path.size(); ++w) {
        speed.push_back(grid.at(path[w]));
        // The rear wheel is there by its delay later: the speed is that of the time between.
        time.push_back((static_cast<double>(w * hop) + 0.5 * static_cast<double>(length)) / rate +
                       0.5 * pairs.front().distance_m() / speed.back());
    }
    return path_through(time, smoothed(speed, options), static_cast<double>(samples.front().size()) / rate, options);
}

/// What two channels say of one window, laid on the track: spectra over waves per metre.
struct LaidWindow {
    double time_s = 0.0;         ///< between the passages of front and rear
    double wave_step = 0.0;      ///< cycles/m between neighbouring values
    std::vector<Complex> cross;  ///< of unit magnitude; 0 where there is nothing
};

/// All windows of a pair. They begin every hop of the path's time, and are as long in metres as the path is there.
std::vector<LaidWindow> laid_windows(const std::vector<double>& front, const std::vector<double>& rear,
                                     const SpeedPair& pair, const TrackPath& path, double rate,
                                     const RunningSpeedOptions& options) {
    const FourierTransform transform(fast_length(static_cast<std::size_t>(options.window_s * rate)));
    const std::size_t length = transform.length();
    const std::vector<double> window = window_samples(Window::hann, length);
    const double end_s = static_cast<double>(front.size()) / rate;
    std::vector<LaidWindow> laid;
    std::vector<double> a(length), b(length);
    std::vector<Complex> fa(transform.bins()), fb(transform.bins());
    for (double begin = 0.0; begin + options.window_s <= end_s; begin += options.hop_s) {
        const double first_m = path.distance_at(begin) + pair.front_m,
                     step_m = path.speed_at(begin + 0.5 * options.window_s) / rate,
                     last_m = first_m + step_m * static_cast<double>(length);
        if (path.time_at(last_m - pair.rear_m) > end_s) break;
        for (std::size_t i = 0; i < length; ++i) {
            const double place = first_m + step_m * static_cast<double>(i);
            a[i] = window[i] * sample_at(front, rate * path.time_at(place - pair.front_m));
            b[i] = window[i] * sample_at(rear, rate * path.time_at(place - pair.rear_m));
        }
        transform.forward(a.data(), fa.data());
        transform.forward(b.data(), fb.data());
        const double middle = 0.5 * (first_m + last_m);
        LaidWindow own{.time_s = 0.5 * (path.time_at(middle - pair.front_m) + path.time_at(middle - pair.rear_m)),
                       .wave_step = 1.0 / (step_m * static_cast<double>(length)),
                       .cross = std::vector<Complex>(transform.bins())};
        for (std::size_t k = 0; k < fa.size(); ++k) {
            const double f = static_cast<double>(k) * rate / static_cast<double>(length);
            const Complex product = std::conj(fa[k]) * fb[k];
            if (f >= options.from_hz && f <= options.to_hz && std::abs(product) > 0.0)
                own.cross[k] = product / std::abs(product);
        }
        laid.push_back(std::move(own));
    }
    return laid;
}

/// Weight of every wave of a pair: the coherence of its phases over all windows.
std::vector<double> wave_weights(const std::vector<LaidWindow>& windows) {
    constexpr double kMost = 0.95;  // beyond, the ripple of the phase limits, not its noise (estimate_delay())
    std::vector<double> weights(windows.front().cross.size(), 0.0);
    for (std::size_t k = 0; k < weights.size(); ++k) {
        Complex sum = 0.0;
        for (const LaidWindow& window : windows) sum += window.cross[k];
        const double mean = std::min(kMost, std::abs(sum) / static_cast<double>(windows.size())),
                     coherence = mean * mean;
        weights[k] = coherence / (1.0 - coherence);
    }
    return weights;
}

/// What of a window's phases speaks for a relative error ε of its speed: Σ w·Re[c·e^{−2πi·n·d·ε}].
double phase_score(const LaidWindow& window, const std::vector<double>& weights, double distance_m, double error) {
    const Complex turn = std::polar(1.0, -kTwoPi * window.wave_step * distance_m * error);
    Complex phase = 1.0;
    double sum = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k, phase *= turn)
        if (weights[k] > 0.0) sum += weights[k] * (window.cross[k] * phase).real();
    return sum;
}

/// The top of a function near which it is a parabola: among `count` points each side of 0, then between them.
template <typename Score>
double top_of(const Score& score, double range, int count) {
    const double step = range / count;
    int best = -count;
    std::vector<double> value;
    for (int i = -count; i <= count; ++i) value.push_back(score(i * step));
    for (int i = -count; i <= count; ++i)
        if (value[static_cast<std::size_t>(i + count)] > value[static_cast<std::size_t>(best + count)]) best = i;
    double at = best * step, width = step;
    for (int round = 0; round < 3; ++round) {
        const double low = score(at - width), middle = score(at), high = score(at + width),
                     bend = low - 2.0 * middle + high;
        if (bend < 0.0) at += std::clamp(0.5 * (low - high) / bend, -1.0, 1.0) * width;
        width *= 0.25;
    }
    return at;
}

/// One refinement: the path with what the phases of all pairs say of its errors. `range`: relative, of those errors.
RunningSpeed refined(const std::vector<std::vector<double>>& samples, const std::vector<SpeedPair>& pairs,
                     const TrackPath& path, double rate, double range, const RunningSpeedOptions& options) {
    std::vector<std::vector<LaidWindow>> laid;
    std::vector<std::vector<double>> weights;
    for (const SpeedPair& pair : pairs) {
        laid.push_back(laid_windows(samples[pair.front], samples[pair.rear], pair, path, rate, options));
        if (laid.back().empty()) return {path};
        weights.push_back(wave_weights(laid.back()));
    }
    std::size_t windows = laid.front().size();
    for (const std::vector<LaidWindow>& own : laid) windows = std::min(windows, own.size());
    std::vector<double> time, errors;
    double scatter = 0.0, explained = 0.0, total = 0.0;
    for (const std::vector<double>& own : weights)
        for (const double weight : own) total += weight * static_cast<double>(windows);
    for (std::size_t w = 0; w < windows; ++w) {
        const auto score = [&](std::size_t p, double error) {
            return phase_score(laid[p][w], weights[p], pairs[p].distance_m(), error);
        };
        const double error = top_of(
            [&](double e) {
                double sum = 0.0;
                for (std::size_t p = 0; p < pairs.size(); ++p) sum += score(p, e);
                return sum;
            },
            range, 24);
        double when = 0.0;
        for (std::size_t p = 0; p < pairs.size(); ++p) {
            when += laid[p][w].time_s / static_cast<double>(pairs.size());
            explained += score(p, error);
            if (pairs.size() < 2) continue;
            const double own = top_of([&](double e) { return score(p, error + e); }, 0.1 * range, 8);
            scatter += own * own / static_cast<double>((pairs.size() - 1) * pairs.size());
        }
        time.push_back(when);
        errors.push_back(error);
    }
    errors = smoothed(errors, options);
    std::vector<double> speed;
    for (std::size_t w = 0; w < windows; ++w) speed.push_back(path.speed_at(time[w]) * (1.0 + errors[w]));
    constexpr double kSinglePair = 2e-5;  // what two bogies alone scatter by at constant speed
    const double end_s = path.step_s * static_cast<double>(path.speed_m_per_s.size() - 1);
    return {.path = path_through(time, speed, end_s, options),
            .relative_error = pairs.size() < 2 ? kSinglePair : std::sqrt(scatter / static_cast<double>(windows)),
            .agreement = total > 0.0 ? explained / total : 0.0,
            .pairs = pairs.size()};
}

}  // namespace

std::optional<RunningSpeed> running_speed(const TimeSeries& series, const VehicleGeometry& geometry, double expected,
                                          const RunningSpeedOptions& options) {
    const std::vector<SpeedPair> pairs = speed_pairs(series, geometry);
    if (pairs.empty() || series.duration_s() < 4.0 * options.window_s) return std::nullopt;
    const std::vector<std::vector<double>> samples = filled(series);
    const double rate = series.sampling_rate_hz;
    RunningSpeed running{.path = first_path(samples, pairs, rate, expected, options)};
    double range = 0.012;  // three steps of the first look
    for (int i = 0; i < options.refinements; ++i, range = std::max(0.5 * range, 1e-3))
        running = refined(samples, pairs, running.path, rate, range, options);
    return running;
}

}  // namespace railpem::recordings

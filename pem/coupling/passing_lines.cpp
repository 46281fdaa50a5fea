#include "pem/coupling/passing_lines.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <optional>

#include "pem/angular_frequency.hpp"
#include "pem/rail/passing_positions.hpp"
#include "track/statics/rolling_pads.hpp"

namespace railpem::pem {

namespace {

constexpr int kOrdersPerBay = 4;  ///< the deflection over a bay has hardly more (fifth order below 1e-3 of the first)
constexpr int kPositionsPerBay = 12;  ///< samples the fourth order three times per wave
/// times the case's own: three deviations of what its compliance is believed to be off by (trial.cpp); beyond,
/// something else excites like the supports
constexpr double kWithinBelief = 1.3;
constexpr int kPulseReach =
    12;  ///< bays on each side of a wheel in which a failed seat is still felt (decay below 1e-4)

int failure_period(const CaseParameters& parameters) {
    const auto& failed = parameters.track.failed_fasteners;
    return failed.empty() ? 0 : failed.front().every;
}

/// k + k' modulo the samples of a period, where the train at sample k' is the mirror image of the train at sample k:
/// seats and equal loads know no direction, and regular failures are symmetric about each of them. Nothing where the
/// wheels are not symmetric or their images fall between the samples.
std::optional<int> mirrored_sum(const CaseParameters& parameters, const std::vector<double>& wheels_m) {
    for (std::size_t i = 0; i < wheels_m.size(); ++i)
        if (std::abs(wheels_m[i] + wheels_m[wheels_m.size() - 1 - i] - wheels_m.front() - wheels_m.back()) > 1e-9)
            return std::nullopt;
    // Wheel 1 stands at X = k/12 − first_seat bays from a failed seat, its image, the last wheel, at D − X.
    const double samples = (wheels_m.front() - wheels_m.back()) / parameters.track.spacing_m * kPositionsPerBay;
    if (std::abs(samples - std::round(samples)) > 1e-9) return std::nullopt;
    const auto& failed = parameters.track.failed_fasteners;
    return static_cast<int>(std::round(samples)) +
           2 * kPositionsPerBay * (failed.empty() ? 0 : failed.front().first_seat);
}

int modulo(int a, int n) {
    return (a % n + n) % n;
}

/// The train at every sampled place of a period; places that are mirror images of others are not computed.
struct Samples {
    struct Sample {
        std::size_t place = 0;  ///< in `positions`
        bool mirrored = false;  ///< then wheel i there is the i-th from behind here
    };
    PassingPositions positions;
    std::vector<Sample> sample;
};

Samples sampled_positions(const CaseParameters& parameters, const std::vector<double>& wheels_m, int period) {
    const std::optional<int> sum = mirrored_sum(parameters, wheels_m);
    std::vector<double> bay_shares;
    std::array<std::size_t, kPositionsPerBay> phase{};
    std::array<bool, kPositionsPerBay> computed{};
    for (int k = 0; k < kPositionsPerBay; ++k) {
        const std::size_t own = static_cast<std::size_t>(k);
        computed[own] = !sum || modulo(*sum - k, kPositionsPerBay) >= k;
        if (!computed[own]) continue;
        phase[own] = bay_shares.size();
        bay_shares.push_back(static_cast<double>(k) / kPositionsPerBay);
    }
    const auto& failed = parameters.track.failed_fasteners;
    std::vector<int> first_seats;  // the bays of a phase one after the other
    for (int bay = 0; bay < period; ++bay)
        first_seats.push_back((failed.empty() ? 0 : failed.front().first_seat) - bay);
    Samples samples{{parameters, wheels_m, bay_shares, first_seats}, {}};
    for (int k = 0; k < kPositionsPerBay * period; ++k) {
        const bool mirrored = !computed[static_cast<std::size_t>(k % kPositionsPerBay)];
        const int source = mirrored ? modulo(*sum - k, kPositionsPerBay * period) : k;
        samples.sample.push_back({samples.positions.place(phase[static_cast<std::size_t>(source % kPositionsPerBay)],
                                                          static_cast<std::size_t>(source / kPositionsPerBay)),
                                  mirrored});
    }
    return samples;
}

/// Fourier coefficient m of −P0·ΣC over a period of n bays, for each order of a lane group, at half of each order's own
/// frequency.
std::array<std::array<std::complex<double>, 4>, lanes::width> coefficients(const CaseParameters& parameters,
                                                                           const Samples& train,
                                                                           const std::array<int, lanes::width>& orders,
                                                                           int period, double speed) {
    lanes::Real omega{};
    for (int lane = 0; lane < lanes::width; ++lane)
        omega[lane] = 0.5 * kTwoPi * orders[lane] * speed / (period * parameters.track.spacing_m);
    const int samples = kPositionsPerBay * period;
    assert(train.sample.size() == static_cast<std::size_t>(samples));
    const double share = wheel_load_n(parameters) / samples;
    std::vector<std::complex<double>> roots;  // of unity: e^{−2πi·k/samples}
    for (int k = 0; k < samples; ++k) roots.push_back(std::polar(1.0, -kTwoPi * k / samples));
    const std::vector<lanes::Complex> deflection = train.positions.deflection(omega);
    std::array<lanes::Complex, 4> sum{};
    for (int k = 0; k < samples; ++k) {
        lanes::Real re{}, im{};
        for (int lane = 0; lane < lanes::width; ++lane) {
            const std::complex<double>& root = roots[static_cast<std::size_t>(orders[lane] * k % samples)];
            re[lane] = root.real();
            im[lane] = root.imag();
        }
        const auto& [place, mirrored] = train.sample[static_cast<std::size_t>(k)];
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            sum[wheel] += deflection[4 * place + (mirrored ? 3 - wheel : wheel)] * lanes::Complex(re, im);
    }
    std::array<std::array<std::complex<double>, 4>, lanes::width> result{};
    for (int lane = 0; lane < lanes::width; ++lane)
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            result[static_cast<std::size_t>(lane)][wheel] = -share * sum[wheel][lane];
    return result;
}

/// Sound fasteners: `factor` times the rail under wheels that roll or stand, in closed form but for what load changes.
std::vector<SpectralLine> lines_of_the_bays(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                            double speed, double factor, bool standing,
                                            const track::PadHistory* known = nullptr) {
    const double spacing = parameters.track.spacing_m;
    const int orders = std::min(kOrdersPerBay, static_cast<int>(parameters.frequency.to_hz * spacing / speed));
    const track::PadHistory history =
        known ? *known
              : track::pad_history(parameters.track, wheels_m, wheel_load_n(parameters), speed, standing, {}, nullptr,
                                   parameters.modifiers.track);
    const auto deflection = track::rolling_deflection(parameters.track, wheels_m, speed, history, orders, standing,
                                                      parameters.modifiers.track);
    std::vector<SpectralLine> lines;
    for (int m = 1; m <= orders; ++m) {
        SpectralLine line{.frequency_hz = m * speed / spacing};
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            line.amplitude_m[wheel] = -2.0 * factor * deflection[static_cast<std::size_t>(m - 1) * 4 + wheel];
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

double own_passing(const CaseParameters& parameters) {
    const double factor = parameters.sleeper_passing.amplitude_factor;
    return parameters.track.failed_fasteners.empty() ? std::min(factor, kWithinBelief) : factor;
}

double excess_passing(const CaseParameters& parameters) {
    return parameters.sleeper_passing.amplitude_factor - own_passing(parameters);
}

std::vector<SpectralLine> unit_excess_lines(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                            double speed) {
    return lines_of_the_bays(parameters, wheels_m, speed, 1.0, true);
}

std::vector<SpectralLine> passing_lines(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                        double speed, const track::PadHistory* rolling) {
    const double factor = parameters.sleeper_passing.amplitude_factor;
    const int period = std::max(1, failure_period(parameters));
    if (factor == 0.0 && period == 1) return {};
    if (period == 1) return lines_of_the_bays(parameters, wheels_m, speed, own_passing(parameters), false, rolling);
    const double spacing = parameters.track.spacing_m;
    const int highest =
        std::min(kOrdersPerBay * period, static_cast<int>(parameters.frequency.to_hz * period * spacing / speed));
    const Samples train = sampled_positions(parameters, wheels_m, period);
    std::vector<SpectralLine> lines;
    for (int first = 1; first <= highest; first += lanes::width) {
        std::array<int, lanes::width> orders;
        for (int lane = 0; lane < lanes::width; ++lane) orders[lane] = std::min(first + lane, highest);
        const auto amplitudes = coefficients(parameters, train, orders, period, speed);
        for (int lane = 0; lane < lanes::width && first + lane <= highest; ++lane) {
            // Orders of the whole bay are the sleepers'; the others exist only because fasteners have failed.
            const double scale = 2.0 * (orders[lane] % period == 0 ? factor : 1.0);
            SpectralLine line{.frequency_hz = orders[lane] * speed / (period * spacing)};
            for (std::size_t wheel = 0; wheel < 4; ++wheel) line.amplitude_m[wheel] = scale * amplitudes[lane][wheel];
            lines.push_back(line);
        }
    }
    return lines;
}

std::function<std::array<std::complex<double>, 4>(double)> failed_fastener_amplitudes(
    const CaseParameters& parameters, const std::vector<double>& wheels_m, double speed) {
    if (parameters.track.failed_fasteners.empty() || parameters.track.failed_fasteners.front().fraction == 0.0)
        return nullptr;
    const double share = parameters.track.failed_fasteners.front().fraction, spacing = parameters.track.spacing_m;
    CaseParameters one = parameters, intact = parameters;
    one.track.failed_fasteners.front().every = 1 << 30;  // one seat only
    intact.track.failed_fasteners.clear();
    constexpr int kFine = 4;  // positions per bay
    const std::vector<double> bay_shares{0.0, 0.25, 0.5, 0.75};
    const int last = kPulseReach + static_cast<int>(std::ceil((wheels_m.front() - wheels_m.back()) / spacing));
    std::vector<int> first_seats;  // the failed one, from far ahead of wheel 1 to far behind the last
    for (int bay = -kPulseReach; bay <= last; ++bay) first_seats.push_back(-bay);
    const lanes::Real quasi_static = lanes::broadcast(kTwoPi * parameters.track.pads.reference_frequency_hz);
    const PassingPositions failing(one, wheels_m, bay_shares, first_seats), sound(intact, wheels_m, bay_shares, {0});
    const std::vector<lanes::Complex> with = failing.deflection(quasi_static), without = sound.deflection(quasi_static);

    std::vector<std::array<double, 4>> pulse;
    for (int k = 0; k <= (last + kPulseReach) * kFine; ++k) {
        const std::size_t quarter = static_cast<std::size_t>(k % kFine), bay = static_cast<std::size_t>(k / kFine);
        pulse.emplace_back();
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            pulse.back()[wheel] = -wheel_load_n(parameters) * (with[failing.place(quarter, bay) * 4 + wheel].re[0] -
                                                               without[sound.place(quarter, 0) * 4 + wheel].re[0]);
    }
    return [=](double frequency) {
        std::array<std::complex<double>, 4> sum{};
        // where the pulse begins turns all phases alike
        const double wavenumber = kTwoPi * frequency / speed, step = spacing / kFine;
        // The rail's bending leaves nothing of the pulse above the samples' Nyquist wavenumber (it falls with its
        // fourth power); the sum over samples would repeat the long waves there.
        if (wavenumber * step > std::numbers::pi) return sum;
        const std::complex<double> turn = std::polar(1.0, -wavenumber * step);
        std::complex<double> turned = std::sqrt(2.0 * share * (1.0 - share) / spacing / speed) * step;
        for (const std::array<double, 4>& own : pulse) {
            for (std::size_t wheel = 0; wheel < 4; ++wheel) sum[wheel] += own[wheel] * turned;
            turned *= turn;
        }
        return sum;
    };
}

}  // namespace railpem::pem

#include "track/rail/rolling_receptance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lanes/elementary_lanes.hpp"
#include "track/elements/rail_element.hpp"
#include "track/rail/exact_rail.hpp"
#include "track/statics/seat_row.hpp"

namespace railpem::track {

namespace {

using lanes::Complex;
using lanes::Real;
using Phasor = std::complex<double>;

/// an even number of terms of Σ_n beyond the highest order, on each side; what is left falls with n⁻⁴, and of a rail
/// that shears with n⁻²
constexpr int kAliasesBeyond = 4;
constexpr double kLogImages = 11.5;  ///< −log 1e-5
/// in wavenumbers of the rail on its supports, beyond the highest order; p_m falls with its eighth power
constexpr double kWaveReach = 6.0;
constexpr double kBreakFelt = 4.0, kBreakAmongWaves = 1.5;  ///< in the same
constexpr double kRefined = 4.0, kMostRefined = 10.0;
constexpr double kMostWaves = 20000.0;
constexpr double kLeast_rad_per_s = 1e-6;

struct WaveGrid {
    double step;
    int groups;    ///< of lanes::width points, from the middle to either side
    double shift;  ///< of the middle: ω' = 0, where losses turn their sign, lies half-way between two points
    double half() const { return groups * lanes::width * step; }
};

WaveGrid wavenumber_grid(const TrackParameters& track, const TrackModifiers& modifiers, double pad_stiffness,
                         double omega, double farthest, double speed, int highest) {
    const Phasor seat =
        SupportLaw(track.pads, track.support, lanes::broadcast(omega), modifiers).stiffness(pad_stiffness)[0];
    const BeamCoefficients beam =
        beam_coefficients(track.rail, track.rail_dampers, lanes::broadcast(omega), modifiers.rail);
    // and root·iⁿ
    const Phasor fourth = (beam.inertia[0] - seat / track.spacing_m) / beam.bending[0], root = std::pow(fourth, 0.25);
    const double foundation = std::pow(std::abs(seat) / track.spacing_m / std::abs(beam.bending[0]), 0.25);
    const double decay = std::max(1e-3, std::min(std::abs(root.real()), std::abs(root.imag())));
    const double half =
        kWaveReach * std::max(std::abs(root), foundation) + highest * 2.0 * std::numbers::pi / track.spacing_m;
    // What losses that turn their sign at ω' = 0 make of the rail does not decay exponentially: the rule is as good
    // there as its step is short.
    const double place = omega / speed / foundation, refined = place < kBreakAmongWaves ? kMostRefined
                                                               : place < kBreakFelt     ? kRefined
                                                                                        : 1.0;
    const double step =
        std::max(2.0 * std::numbers::pi / (farthest + kLogImages / decay) / refined, 2.0 * half / kMostWaves);
    return {step, static_cast<int>(std::ceil(half / step / lanes::width)), std::remainder(omega / speed, step)};
}

/// What p_m are made of at a group of wavenumbers and ω' > 0.
struct Seats {
    BeamCoefficients beam;
    Complex seat;
    Complex held;   ///< L + K·Σ 1/D_n, n ≠ 0
    Complex share;  ///< 1/(D_0·held + K): D_0 is zero where a wave of the free rail is, and multiplies

    /// `alias`: receives 1/D_n up to ±highest, at n + highest.
    Seats(const TrackParameters& track, const TrackModifiers& modifiers, double pad_stiffness, Real k, Real omega,
          int highest, Complex* alias)
        : beam(beam_coefficients(track.rail, track.rail_dampers, omega, modifiers.rail)),
          seat(SupportLaw(track.pads, track.support, omega, modifiers).stiffness(pad_stiffness)) {
        const double bay = 2.0 * std::numbers::pi / track.spacing_m;
        Complex others;
        for (int n = 1; n <= highest; ++n)
            for (const int side : {-n, n})
                others += alias[side + highest] = lanes::reciprocal(beam_stiffness(beam, k + side * bay));
        const int last = highest + kAliasesBeyond;
        for (int n = highest + 1; n <= last; n += 2) others += sum_of_reciprocals(k, n * bay, (n + 1) * bay);
        // Beyond them s/k² + 1/(Bk⁴): ∫ from half a step on.
        const double end = bay * (last + 0.5);
        others +=
            (beam.shear_compliance + lanes::reciprocal(beam.bending) * (1.0 / (3.0 * end * end))) * (2.0 / (bay * end));
        held = seat * others + track.spacing_m;
        share = lanes::reciprocal(beam_stiffness(beam, k) * held + seat);
    }

  private:
    /// Σ 1/D at k ± a and k ± b with one division, which is what takes longest.
    Complex sum_of_reciprocals(Real k, double a, double b) const {
        const Complex ahead = beam_stiffness(beam, k + a), behind = beam_stiffness(beam, k - a),
                      far_ahead = beam_stiffness(beam, k + b), far_behind = beam_stiffness(beam, k - b);
        const Complex near = ahead * behind, far = far_ahead * far_behind;
        return ((ahead + behind) * far + (far_ahead + far_behind) * near) * lanes::reciprocal(near * far);
    }
};

/// p_m at a group of wavenumbers, m = −highest … highest.
void periodic_part(const TrackParameters& track, const TrackModifiers& modifiers, double pad_stiffness, Real k,
                   Real omega, int highest, std::vector<Complex>& p) {
    const Real least = lanes::broadcast(kLeast_rad_per_s), size = omega < Real{} ? -omega : omega;
    const Seats seats(track, modifiers, pad_stiffness, k, size < least ? least : size, highest, p.data());
    const Complex through = seats.share * seats.seat;
    for (int m = -highest; m <= highest; ++m) {
        Complex& part = p[static_cast<std::size_t>(m + highest)];
        part = m == 0 ? seats.share * seats.held : -(through * part);
        part.im = omega < Real{} ? -part.im : part.im;
    }
}

/// ∫ from k outwards of e^{ikx}/D with 1/D = s/k² + 1/(Bk⁴), which is all that is left there; x ≠ 0: two terms of its
/// asymptotic series in 1/(kx).
Phasor free_rail_beyond(const BeamCoefficients& beam, double k, double x) {
    const Phasor s = beam.shear_compliance[0], b = 1.0 / beam.bending[0], i(0.0, 1.0);
    if (x == 0.0) return s / k + b / (3.0 * k * k * k);
    const double k2 = k * k;
    const Phasor density = s / k2 + b / (k2 * k2), slope = -2.0 / k * (s / k2 + 2.0 * b / (k2 * k2));
    return std::polar(1.0, k * x) * (i * density / x - slope / (x * x));
}

/// What the grid leaves out of order 0. From ω' = 0 on the rail's constant loss has the other sign.
Phasor beyond_reach(const TrackParameters& track, const TrackModifiers& modifiers, const WaveGrid& grid, double omega,
                    double speed, double x) {
    const BeamCoefficients beam =
        beam_coefficients(track.rail, track.rail_dampers, lanes::broadcast(omega), modifiers.rail);
    BeamCoefficients turned = beam;
    turned.bending.im = -beam.bending.im, turned.shear_compliance.im = -beam.shear_compliance.im;
    const double reversal = std::max(grid.half() + grid.shift, omega / speed);
    return free_rail_beyond(beam, grid.half() - grid.shift, -x) + free_rail_beyond(beam, grid.half() + grid.shift, x) -
           free_rail_beyond(beam, reversal, x) + free_rail_beyond(turned, reversal, x);
}

/// Distances |x_i − x_j| that differ, and which pair has which, forwards or backwards.
struct Distances {
    struct OfPair {
        std::size_t distance;
        bool backwards;
    };
    std::vector<double> each;
    std::vector<OfPair> of_pair;

    explicit Distances(const std::vector<double>& wheels) {
        for (const double felt : wheels)
            for (const double force : wheels) {
                const double own = std::abs(felt - force);
                const auto known = std::find_if(each.begin(), each.end(),
                                                [&](double other) { return std::abs(other - own) < kSameNode; });
                of_pair.push_back({static_cast<std::size_t>(known - each.begin()), felt < force});
                if (known == each.end()) each.push_back(own);
            }
    }
    double farthest() const { return *std::max_element(each.begin(), each.end()); }
};

/// e^{ikx} of every distance along the grid: each group's from that of the group before, taken anew often enough for
/// rounding not to add up.
class Waves {
  public:
    Waves(const std::vector<double>& distances_m, double step) : distances_(distances_m), wave_(distances_m.size()) {
        for (const double distance : distances_m) turn_.emplace_back(std::polar(1.0, lanes::width * step * distance));
    }

    /// At the wavenumbers `k`; groups one after the other, none left out.
    const std::vector<Complex>& at(Real k) {
        constexpr int kAnew = 32;  ///< groups: 32 roundings are some 1e-15
        for (std::size_t d = 0; d < wave_.size(); ++d)
            wave_[d] = groups_ % kAnew == 0 ? lanes::unit(k * distances_[d]) : wave_[d] * turn_[d];
        ++groups_;
        return wave_;
    }

  private:
    const std::vector<double>& distances_;
    std::vector<Complex> turn_, wave_;
    int groups_ = 0;
};

/// Σ p·e^{ikx} and Σ p·e^{−ikx} side by side: their products are the same four.
struct BothWays {
    Real rr{}, ii{}, ri{}, ir{};

    void add(const Complex& p, const Complex& wave) {
        rr += p.re * wave.re;
        ii += p.im * wave.im;
        ri += p.re * wave.im;
        ir += p.im * wave.re;
    }
    Phasor sum(bool backwards) const {
        const Real re = backwards ? rr + ii : rr - ii, im = backwards ? ir - ri : ir + ri;
        Phasor whole = 0.0;
        for (int lane = 0; lane < lanes::width; ++lane) whole += Phasor(re[lane], im[lane]);
        return whole;
    }
};

}  // namespace

RollingReceptance rolling_receptance(const TrackParameters& track, double pad_stiffness_n_per_m,
                                     const std::vector<double>& wheels_m, double speed_m_per_s, double frequency_hz,
                                     int highest, const TrackModifiers& modifiers) {
    const double omega = 2.0 * std::numbers::pi * frequency_hz;
    const Distances distances(wheels_m);
    const WaveGrid grid =
        wavenumber_grid(track, modifiers, pad_stiffness_n_per_m, omega, distances.farthest(), speed_m_per_s, highest);
    const std::size_t orders = static_cast<std::size_t>(2 * highest + 1), count = distances.each.size();
    std::vector<Complex> p(orders);
    std::vector<BothWays> sums(orders * count);
    Waves waves(distances.each, grid.step);
    for (int group = -grid.groups; group < grid.groups; ++group) {
        Real k;
        for (int lane = 0; lane < lanes::width; ++lane)
            k[lane] = (group * lanes::width + lane + 0.5) * grid.step + grid.shift;
        periodic_part(track, modifiers, pad_stiffness_n_per_m, k, omega - k * speed_m_per_s, highest, p);
        const std::vector<Complex>& wave = waves.at(k);
        for (std::size_t m = 0; m < orders; ++m)
            for (std::size_t d = 0; d < count; ++d) sums[m * count + d].add(p[m], wave[d]);
    }
    std::vector<std::array<Phasor, 2>> beyond;  // forwards and backwards
    for (const double distance : distances.each)
        beyond.push_back({beyond_reach(track, modifiers, grid, omega, speed_m_per_s, distance) / grid.step,
                          beyond_reach(track, modifiers, grid, omega, speed_m_per_s, -distance) / grid.step});
    const std::size_t wheels = wheels_m.size();
    const double scale = grid.step / (2.0 * std::numbers::pi);
    std::vector<Phasor> place;  // of order −highest under every wheel, then one order further each
    for (const double wheel : wheels_m)
        place.push_back(std::polar(scale, -2.0 * std::numbers::pi * highest * wheel / track.spacing_m));
    std::vector<Phasor> further;
    for (const double wheel : wheels_m)
        further.push_back(std::polar(1.0, 2.0 * std::numbers::pi * wheel / track.spacing_m));
    RollingReceptance result{.highest = highest, .wheels = wheels, .values = {}};
    for (int m = -highest; m <= highest; ++m) {
        for (std::size_t pair = 0; pair < wheels * wheels; ++pair) {
            const auto [distance, backwards] = distances.of_pair[pair];
            Phasor whole = sums[static_cast<std::size_t>(m + highest) * count + distance].sum(backwards);
            if (m == 0) whole += beyond[distance][backwards ? 1 : 0];
            result.values.push_back(whole * (m == 0 ? scale : place[pair / wheels]));
        }
        for (std::size_t wheel = 0; wheel < wheels; ++wheel) place[wheel] *= further[wheel];
    }
    return result;
}

Complex rolling_trackbed(const TrackParameters& track, double pad_stiffness_n_per_m, Real omega,
                         const TrackModifiers& modifiers) {
    const Seats seats(track, modifiers, pad_stiffness_n_per_m, Real{}, omega, 0, nullptr);
    return seats.seat * seats.share;
}

}  // namespace railpem::track

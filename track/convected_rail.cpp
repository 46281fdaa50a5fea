#include "track/convected_rail.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "lanes/elementary_lanes.hpp"

namespace railpem::track {

using lanes::Complex;
using lanes::Real;

namespace {

/// Terms of the sum at most: a wave that decays less than 1e-3 per metre is cut short rather than computed for ever.
constexpr double kMostTerms = 60000.0;
constexpr double kLogImages = 16.1;  ///< −log 1e-7
constexpr double kReach = 8.0;       ///< in wavenumbers of the rail on its supports; the change falls off with its sixth power
constexpr double kBreakFelt = 4.0;   ///< in the same: beyond it a break at ω' = 0 is felt by less than 4^−8 of the receptance
constexpr double kGathered = 8.0;    ///< in steps: how far around the break the points gather
constexpr double kStretched = 1.16;  ///< what they are spread at most elsewhere: 5s² − 4s³ at s = 5/6

/// What D(ω', k) is made of beside k. Losses keep the sign that they have for ω' > 0; D(−ω') is the conjugate, the rail's constant loss included.
struct Laws {
    BeamCoefficients beam;
    Complex foundation;  ///< K/spacing
};

Laws laws_at(const ExactRail& rail, double pad_stiffness, Real size) {
    const Real small = lanes::broadcast(1e-6);
    size = size < small ? small : size;
    Laws laws;
    laws.beam = beam_coefficients(rail.rail, rail.dampers, size);
    laws.foundation = SupportLaw(rail.pads, rail.support, size).stiffness(pad_stiffness) * (1.0 / rail.spacing_m);
    return laws;
}

Complex dynamic_stiffness(const Laws& laws, Real k) { return beam_stiffness(laws.beam, k) + laws.foundation; }

/// Points k = centre ± τ(t), t = (n + ½)·step, with τ = t⁵/(t² + b²)²: the fifth power smooths a break
/// at the centre, which a plain rule would stumble over.
struct Grid {
    double step, centre, gathering;  ///< b; 0: even points, τ = t
    int groups;                      ///< of lanes::width values of t
};

/// Slowest decay per metre of what a resonance below the rail, seen through ω' = ω − kv, makes of R_v: (half its width)/v.
double slowest_resonance(const ExactRail& rail, double pad_stiffness, double omega, double speed, double reach) {
    double slowest = 1e300;
    const auto meet = [&](double natural2, double loss) {
        const double natural = std::sqrt(natural2);
        if (std::abs(natural - omega) < reach * speed) slowest = std::min(slowest, 0.5 * loss / natural / speed);
    };
    for (const RailDamper& damper : rail.dampers) {
        const double natural = 2.0 * std::numbers::pi * damper.frequency_hz;
        meet(natural * natural, natural * natural * damper.loss_factor);
    }
    const SupportParameters& support = rail.support;
    if (support.model == SupportModel::rigid) return slowest;
    const double spring_loss = support.stiffness_n_per_m * support.loss_factor + omega * support.damping_n_s_per_m;
    meet((support.stiffness_n_per_m + pad_stiffness) / support.mass_kg, spring_loss / support.mass_kg);
    for (const SleeperMode& mode : support.bending_modes) {
        const double natural = 2.0 * std::numbers::pi * mode.frequency_hz;
        meet(natural * natural + support.stiffness_n_per_m / support.mass_kg, natural * natural * mode.loss_factor + spring_loss / support.mass_kg);
    }
    return slowest;
}

Grid wavenumber_grid(const ExactRail& rail, double pad_stiffness, double omega, double speed, double farthest) {
    const Complex support = SupportLaw(rail.pads, rail.support, lanes::broadcast(omega)).stiffness(pad_stiffness);
    const BeamCoefficients beam = beam_coefficients(rail.rail, rail.dampers, lanes::broadcast(omega));
    const std::complex<double> fourth = (beam.inertia[0] - support[0] / rail.spacing_m) / beam.bending[0];
    const std::complex<double> root = std::pow(fourth, 0.25);  // and root·i^n
    const double foundation = std::pow(std::abs(support[0]) / rail.spacing_m / std::abs(beam.bending[0]), 0.25);
    const double wavenumber = std::max(std::abs(root), foundation);
    double decay = std::min(std::abs(root.imag()), std::abs(root.real()));
    decay = std::max(1e-4, std::min(decay, slowest_resonance(rail, pad_stiffness, omega, speed, kBreakFelt * wavenumber)));
    const double reach = kReach * wavenumber;
    Grid grid{.step = std::max(2.0 * std::numbers::pi / (farthest + kLogImages / decay), 2.0 * reach / kMostTerms), .centre = 0.0, .gathering = 0.0, .groups = 0};
    double half = reach;
    const double felt = rail.rail.loss_factor > 0.0 ? reach : kBreakFelt * wavenumber;  // a loss of the rail turns its sign there, too
    if (omega / speed < felt) {
        grid.centre = omega / speed;
        grid.step /= kStretched;
        grid.gathering = kGathered * grid.step;
        half += grid.centre;
    }
    grid.groups = static_cast<int>(std::ceil(half / grid.step / lanes::width));
    return grid;
}

/// 1/D_v − 1/D_0 at one frequency and speed.
class Change {
  public:
    Change(const ExactRail& rail, double pad_stiffness, double omega, double speed)
        : rail_(rail), pad_stiffness_(pad_stiffness), omega_(omega), speed_(speed), at_rest_(laws_at(rail, pad_stiffness, lanes::broadcast(omega))) {}

    Complex operator()(Real k) const {  // (D_0 − D_v)/(D_v·D_0)
        const Real convected = omega_ - speed_ * k, size = convected < Real{} ? -convected : convected;
        Complex moving = dynamic_stiffness(laws_at(rail_, pad_stiffness_, size), k);
        moving.im = convected < Real{} ? -moving.im : moving.im;
        const Complex resting = dynamic_stiffness(at_rest_, k);
        return (resting - moving) / (moving * resting);
    }
    /// Where ω' = 0 and losses turn their sign.
    double reversal() const { return omega_ / speed_; }
    const Laws& at_rest() const { return at_rest_; }

  private:
    const ExactRail& rail_;
    double pad_stiffness_, omega_, speed_;
    Laws at_rest_;
};

/// ∫ of the change from k = `from` outwards to from/`last`, last = 0: for ever. Gauss–Legendre, 8 points in u = from/k, in which k^−2 dk is
/// constant.
std::complex<double> outwards(const Change& change, double from, double last) {
    constexpr std::array<double, 4> at{0.183434642495649805, 0.525532409916328986, 0.796666477413626740, 0.960289856497536232};
    constexpr std::array<double, 4> weight{0.362683783378361983, 0.313706645877887287, 0.222381034453374471, 0.101228536290376259};
    std::complex<double> sum = 0.0;
    for (const double side : {-1.0, 1.0}) {
        Real u;
        for (int lane = 0; lane < lanes::width; ++lane) u[lane] = 0.5 * (1.0 + last) + 0.5 * (1.0 - last) * side * at[static_cast<std::size_t>(lane)];
        const Complex density = change(from / u) * (1.0 / (u * u));
        for (int lane = 0; lane < lanes::width; ++lane) sum += weight[static_cast<std::size_t>(lane)] * density[lane];
    }
    return 0.5 * (1.0 - last) * std::abs(from) * sum;
}

/// What the grid, which ends at `below` < 0 and `above`, leaves out of ∫ e^{ikx}(1/D_v − 1/D_0) dk. A rail in shear needs it: there
/// 1/D_0 = s/k² + 1/(Bk⁴), s the shear compliance, falls off with k^−2 only. For x ≠ 0 the waves cancel but for the step that the
/// constant loss of the rail leaves at the end of the range.
std::complex<double> beyond_reach(const Change& change, double below, double above, double x) {
    const double reversal = change.reversal();
    if (x == 0.0) {
        const std::complex<double> behind = outwards(change, below, 0.0);
        if (reversal <= above) return behind + outwards(change, above, 0.0);
        return behind + outwards(change, above, above / reversal) + outwards(change, reversal, 0.0);
    }
    const double end = std::max(above, reversal);
    const std::complex<double> compliance = change.at_rest().beam.shear_compliance[0] / (end * end) + 1.0 / (change.at_rest().beam.bending[0] * std::pow(end, 4));
    return (std::conj(compliance) - compliance) * std::complex<double>(0.0, 1.0 / x) * std::polar(1.0, end * x);
}

/// τ and dτ/dt.
struct Point {
    Real tau, weight;
};

Point gathered(const Grid& grid, Real t) {
    const Real t2 = t * t, share = t2 / (t2 + grid.gathering * grid.gathering);
    return {t * share * share, share * share * (5.0 - 4.0 * share)};
}

/// Σ (F₊ + F₋)·cos τd and Σ (F₊ − F₋)·sin τd with F± = F(centre ± τ).
struct Sums {
    Complex even, odd;
};

}  // namespace

void convected_change(const ExactRail& rail, double pad_stiffness_n_per_m, double omega, double speed_m_per_s,
                      const std::vector<double>& distances_m, ConvectedChange* change) {
    assert(distances_m.size() <= kMostDistances);
    std::fill_n(change, distances_m.size(), ConvectedChange{});
    if (speed_m_per_s == 0.0 || distances_m.empty()) return;
    const Grid grid = wavenumber_grid(rail, pad_stiffness_n_per_m, omega, speed_m_per_s, *std::max_element(distances_m.begin(), distances_m.end()));
    const Change difference(rail, pad_stiffness_n_per_m, omega, speed_m_per_s);
    std::array<Sums, kMostDistances> sums{};
    for (int group = 0; group < grid.groups; ++group) {
        Real t;
        for (int lane = 0; lane < lanes::width; ++lane) t[lane] = (group * lanes::width + lane + 0.5) * grid.step;
        const auto [tau, weight] = gathered(grid, t);
        const Complex ahead = difference(grid.centre + tau) * weight, behind = difference(grid.centre - tau) * weight;
        const Complex even = ahead + behind, odd = ahead - behind;
        for (std::size_t i = 0; i < distances_m.size(); ++i) {
            const Complex wave = lanes::unit(tau * distances_m[i]);
            sums[i].even += even * wave.re;
            sums[i].odd += odd * wave.im;
        }
    }
    const double half = gathered(grid, lanes::broadcast(grid.groups * lanes::width * grid.step)).tau[0];
    for (std::size_t i = 0; i < distances_m.size(); ++i) {
        std::complex<double> even = 0.0, odd = 0.0;
        for (int lane = 0; lane < lanes::width; ++lane) even += sums[i].even[lane], odd += std::complex<double>(0.0, 1.0) * sums[i].odd[lane];
        const std::complex<double> centre = std::polar(1.0, grid.centre * distances_m[i]);
        change[i].ahead = grid.step / (2.0 * std::numbers::pi) * centre * (even + odd);
        change[i].behind = grid.step / (2.0 * std::numbers::pi) * std::conj(centre) * (even - odd);
        const double x = distances_m[i], below = grid.centre - half, above = grid.centre + half;
        change[i].ahead += beyond_reach(difference, below, above, x) / (2.0 * std::numbers::pi);
        change[i].behind += beyond_reach(difference, below, above, -x) / (2.0 * std::numbers::pi);
    }
}

}  // namespace railpem::track

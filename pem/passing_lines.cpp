#include "pem/passing_lines.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "pem/rail_model.hpp"
#include "track/exact_rail.hpp"

namespace railpem::pem {

namespace {

using Complex = std::complex<double>;
constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr int kOrdersPerBay = 4;  ///< the deflection over a bay has hardly more (fifth order below 1e-3 of the first)
constexpr int kPositionsPerBay = 12;  ///< samples the fourth order three times per wave
constexpr double kPulseReach =
    12;  ///< bays on each side of a wheel in which a failed seat is still felt (decay below 1e-4)

/// Deflection under the standing load of wheel `wheel` per newton: Σ_j C_wj at the given frequencies (one lane group).
lanes::Complex compliance(const CaseParameters& parameters, const std::vector<double>& wheels_m, lanes::Real omega,
                          std::size_t wheel) {
    const track::ExactRail rail = track::exact_rail(parameters.track, wheels_m, dynamic_equilibrium(parameters));
    track::ExactRailWorkspace workspace(rail);
    const track::RailReceptance& receptance = track::rail_receptance(rail, omega, workspace);
    lanes::Complex sum;
    for (std::size_t j = 0; j < wheels_m.size(); ++j)
        sum += receptance.at(static_cast<int>(wheel), static_cast<int>(j));
    return sum;
}

int failure_period(const CaseParameters& parameters) {
    const auto& failed = parameters.track.failed_fasteners;
    return failed.empty() ? 0 : failed.front().every;
}

/// The case with the train moved by `position` bays, regular failures staying where they are, random ones left out.
CaseParameters moved_case(const CaseParameters& parameters, double position_bays) {
    CaseParameters moved = parameters;
    const double bays = std::floor(position_bays);
    moved.track.wheel_offset_m = (position_bays - bays) * parameters.track.spacing_m;
    for (track::FailedFasteners& failed : moved.track.failed_fasteners) {
        failed.first_seat -= static_cast<int>(bays);
        failed.fraction = 0.0;
    }
    return moved;
}

/// The rail under the train at every sampled position of a period; built once, it serves all orders and wheels.
std::vector<track::ExactRail> sampled_rails(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                            int period) {
    std::vector<track::ExactRail> rails;
    track::StaticEquilibrium previous;  // of a train one sample behind: a near start for the next
    for (int k = 0; k < kPositionsPerBay * period; ++k) {
        const CaseParameters moved = moved_case(parameters, static_cast<double>(k) / kPositionsPerBay);
        previous = dynamic_equilibrium(moved, &previous);
        rails.push_back(track::exact_rail(moved.track, wheels_m, previous));
    }
    return rails;
}

/// Fourier coefficient m of −P0·ΣC over a period of n bays, for each order of a lane group, at each order's own
/// frequency.
std::array<std::array<Complex, 4>, lanes::width> coefficients(const CaseParameters& parameters,
                                                              const std::vector<track::ExactRail>& rails,
                                                              const std::array<int, lanes::width>& orders, int period,
                                                              double speed) {
    lanes::Real omega{};
    for (int lane = 0; lane < lanes::width; ++lane)
        omega[lane] = kTwoPi * orders[lane] * speed / (period * parameters.track.spacing_m);
    const int samples = static_cast<int>(rails.size());
    const double share = wheel_load_n(parameters) / samples;
    std::array<std::array<Complex, 4>, lanes::width> result{};
    for (int k = 0; k < samples; ++k) {
        track::ExactRailWorkspace workspace(rails[static_cast<std::size_t>(k)]);
        const track::RailReceptance& receptance =
            track::rail_receptance(rails[static_cast<std::size_t>(k)], omega, workspace);
        for (int wheel = 0; wheel < 4; ++wheel) {
            lanes::Complex sum;
            for (int j = 0; j < 4; ++j) sum += receptance.at(wheel, j);
            for (int lane = 0; lane < lanes::width; ++lane)
                result[lane][wheel] -= share * sum[lane] * std::polar(1.0, -kTwoPi * orders[lane] * k / samples);
        }
    }
    return result;
}

}  // namespace

std::vector<SpectralLine> passing_lines(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                        double speed) {
    const double factor = parameters.sleeper_passing.amplitude_factor;
    const int period = std::max(1, failure_period(parameters));
    if (factor == 0.0 && period == 1) return {};
    const double spacing = parameters.track.spacing_m;
    const int highest =
        std::min(kOrdersPerBay * period, static_cast<int>(parameters.frequency.to_hz * period * spacing / speed));
    const std::vector<track::ExactRail> rails = sampled_rails(parameters, wheels_m, period);
    std::vector<SpectralLine> lines;
    for (int first = 1; first <= highest; first += lanes::width) {
        std::array<int, lanes::width> orders;
        for (int lane = 0; lane < lanes::width; ++lane) orders[lane] = std::min(first + lane, highest);
        const auto amplitudes = coefficients(parameters, rails, orders, period, speed);
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

std::function<double(double)> failed_fastener_spectrum(const CaseParameters& parameters,
                                                       const std::vector<double>& wheels_m, double speed) {
    if (parameters.track.failed_fasteners.empty() || parameters.track.failed_fasteners.front().fraction == 0.0)
        return nullptr;
    const double share = parameters.track.failed_fasteners.front().fraction;
    const double spacing = parameters.track.spacing_m;
    CaseParameters one = parameters;
    track::FailedFasteners& failed = one.track.failed_fasteners.front();
    failed.fraction = 0.0;
    failed.every = 1 << 30;   // one seat only
    constexpr int kFine = 4;  // positions per bay
    const lanes::Real quasi_static = lanes::broadcast(kTwoPi * parameters.track.pads.reference_frequency_hz);
    CaseParameters intact = parameters;
    intact.track.failed_fasteners.clear();

    std::vector<double> position, pulse;
    for (int k = -static_cast<int>(kPulseReach) * kFine; k <= static_cast<int>(kPulseReach) * kFine; ++k) {
        const double bays = static_cast<double>(k) / kFine;
        one.track.wheel_offset_m = intact.track.wheel_offset_m = (bays - std::floor(bays)) * spacing;
        failed.first_seat = -static_cast<int>(std::floor(bays));
        const double change = compliance(one, wheels_m, quasi_static, 0)[0].real() -
                              compliance(intact, wheels_m, quasi_static, 0)[0].real();
        position.push_back(bays * spacing);
        pulse.push_back(-wheel_load_n(parameters) * change);
    }
    return [=](double frequency) {
        const double wavenumber = kTwoPi * frequency / speed;
        // The rail's bending leaves nothing of the pulse above the samples' Nyquist wavenumber (it falls with its
        // fourth power); the sum over samples would repeat the long waves there.
        if (wavenumber * spacing / kFine > std::numbers::pi) return 0.0;
        Complex transform = 0.0;
        for (std::size_t i = 0; i < pulse.size(); ++i)
            transform += pulse[i] * std::polar(spacing / kFine, -wavenumber * position[i]);
        return 2.0 * share * (1.0 - share) / spacing * std::norm(transform) / speed;
    };
}

}  // namespace railpem::pem

#include "track/rail/mean_seats.hpp"

#include <numbers>

#include "track/elements/rail_element.hpp"
#include "track/pads/support_law.hpp"
#include "track/rail/exact_rail.hpp"

namespace railpem::track {

namespace {

using lanes::Complex;

constexpr double kFirst_hz = 1.0, kStep_hz = 3.0, kLast_hz = 300.0, kRatio = 1.05, kEnd_hz = 800.0;
constexpr int kIterations = 12;

std::vector<double> frequencies() {
    std::vector<double> result{kFirst_hz};
    while (result.back() < kEnd_hz)
        result.push_back(result.back() < kLast_hz ? result.back() + kStep_hz : kRatio * result.back());
    return result;
}

/// s in the place of K.
Complex scattered(const Complex& seat, const Complex& equal, const Complex& receptance) {
    const Complex change = seat - equal;
    return change / (change * receptance + 1.0);
}

}  // namespace

lanes::FactorCurve mean_of_failed(const TrackParameters& track, double pad_stiffness, const TrackModifiers& modifiers) {
    double share = 0.0, left = 1.0;
    for (const FailedFasteners& failed : track.failed_fasteners)
        if (failed.fraction > 0.0) share = failed.fraction, left = failed.remaining_stiffness_fraction;
    lanes::FactorCurve curve;
    if (share == 0.0) return curve;
    const ExactRail rail = uniform_rail(track, {0.0}, pad_stiffness, modifiers);
    for (const double f : frequencies()) {
        const lanes::Real omega = lanes::broadcast(2.0 * std::numbers::pi * f);
        const SupportLaw law(track.pads, track.support, omega, modifiers);
        const RailElement bay =
            rail_element(beam_coefficients(track.rail, track.rail_dampers, omega, modifiers.rail), track.spacing_m);
        const Complex sound = law.stiffness(pad_stiffness), failed = law.stiffness(pad_stiffness, left),
                      below = support_receptance(track.support, omega, modifiers.support);
        Complex equal = sound * (1.0 - share) + failed * share;
        for (int i = 0; i < kIterations; ++i) {
            const Complex receptance =
                lanes::reciprocal(uniform_half_track(rail, omega, bay, equal).stiffness.a * 2.0 + equal);
            const Complex mean =
                scattered(sound, equal, receptance) * (1.0 - share) + scattered(failed, equal, receptance) * share;
            equal += mean / (mean * receptance + 1.0);
        }
        // Pads of the equal seats over those of the sound ones: 1/K = 1/pad + below.
        const Complex pad = equal / (Complex(1.0) - equal * below), own = sound / (Complex(1.0) - sound * below);
        curve.frequency_hz.push_back(f);
        curve.value.push_back((pad / own)[0]);
    }
    return curve;
}

}  // namespace railpem::track

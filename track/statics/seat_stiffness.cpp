#include "track/statics/seat_stiffness.hpp"

#include <numbers>

#include "track/pads/pad_law.hpp"
#include "track/pads/support_law.hpp"

namespace railpem::track {

namespace {

/// What all seats have in common at one frequency.
struct SeatDynamics {
    std::complex<double> shape, dashpot, below;

    SeatDynamics(const TrackParameters& track, double frequency_hz, const TrackModifiers& modifiers)
        : shape(pad_shape(track.pads, frequency_hz)),
          dashpot(0.0, 2.0 * std::numbers::pi * frequency_hz * pad_damping(track.pads)),
          below(support_receptance(track.support, frequency_hz, modifiers.support)) {
        if (modifiers.pads.empty()) return;
        const std::complex<double> factor = modifiers.pads.at(2.0 * std::numbers::pi * frequency_hz);
        shape *= factor;
        dashpot *= factor;
    }

    std::complex<double> stiffness(double dynamic_stiffness_n_per_m, double remaining_fraction) const {
        return support_stiffness(remaining_fraction * (dynamic_stiffness_n_per_m * shape + dashpot), below);
    }
};

}  // namespace

std::complex<double> seat_stiffness(const TrackParameters& track, double dynamic_stiffness_n_per_m,
                                    double remaining_fraction, double frequency_hz, const TrackModifiers& modifiers) {
    return SeatDynamics(track, frequency_hz, modifiers).stiffness(dynamic_stiffness_n_per_m, remaining_fraction);
}

Eigen::VectorXcd seat_stiffness(const TrackParameters& track, const StaticEquilibrium& equilibrium, double frequency_hz,
                                const TrackModifiers& modifiers) {
    const SeatDynamics dynamics(track, frequency_hz, modifiers);
    Eigen::VectorXcd stiffness(static_cast<Eigen::Index>(equilibrium.position_m.size()));
    for (Eigen::Index j = 0; j < stiffness.size(); ++j)
        stiffness[j] = dynamics.stiffness(equilibrium.dynamic_stiffness_n_per_m[j], equilibrium.remaining_fraction[j]);
    return stiffness;
}

}  // namespace railpem::track

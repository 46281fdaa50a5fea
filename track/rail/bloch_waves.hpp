#pragma once
// The uniform track as its decaying waves, what they show at a point, and what a force at a point sends out.

#include <array>

#include "track/rail/exact_rail.hpp"

namespace railpem::track {

using WavePair = std::array<lanes::Complex, 2>;

/// Per group of lines. A wave that decays towards the front is described by its deflection over a pad; over the next
/// one it is `factor` times that. One that decays towards the rear is its mirror image.
struct BlochWaves {
    WavePair factor;    ///< λ per bay, |λ| ≤ 1
    WavePair rotation;  ///< of the section over a pad, per deflection there, 1/m
    WavePair excited;   ///< deflection over a pad, either way, by a unit force over it, m/N
    BeamCoefficients beam;
    lanes::Complex support;  ///< stiffness of every seat
    /// deflection over every pad when each is loaded with its own stiffness; nothing turns there
    lanes::Complex settled;
    double spacing_m = 0.0;
};

/// The waves of `track` on sound pads of K0 = `pad_stiffness_n_per_m`. ω > 0 in rad/s; `law`: at that ω.
BlochWaves bloch_waves(const TrackParameters& track, double pad_stiffness_n_per_m, lanes::Real omega,
                       const SupportLaw& law, const TrackModifiers& modifiers = {});

/// The waves of the uniform track that `rail` is apart from its finite part.
BlochWaves bloch_waves(const ExactRail& rail, lanes::Real omega, const SupportLaw& law);

/// False where the two waves all but coincide, or one of them leaves the pads at rest (pinned–pinned): there each grows
/// beyond bounds while their sum stays, and what is built on them loses digits.
bool apart(const BlochWaves& waves);

/// A point ahead of a pad, by less than a bay.
struct BayPoint {
    WavePair from_rear;     ///< deflection there per deflection over the pad behind, waves that decay towards the front
    WavePair from_front;    ///< the same per deflection over the pad ahead, waves that decay towards the rear
    lanes::Complex own;     ///< receptance of the uniform track there, m/N
    lanes::Complex lifted;  ///< deflection there when both pads beside it are moved by 1 and nothing turns over them
};

/// By reciprocity a unit force at the point sends excited·from_front over the pad ahead and excited·from_rear over the
/// pad behind. `ahead_m` in [0, spacing).
BayPoint bay_point(const BlochWaves& waves, double ahead_m);

}  // namespace railpem::track

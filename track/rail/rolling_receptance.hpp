#pragma once
// How far the rail gives way under wheels that roll over equal seats, order by order of the bays.

#include <complex>
#include <cstddef>
#include <vector>

#include "lanes/complex_lanes.hpp"
#include "track/track_modifiers.hpp"
#include "track/track_parameters.hpp"

namespace railpem::track {

/// Deflections of the rail, m/N, under wheels that all move at v: a force e^{2πift} at one of them is felt at every
/// other, and at itself, at f + m·v/L.
struct RollingReceptance {
    int highest = 0;  ///< orders −highest to highest
    std::size_t wheels = 0;
    std::vector<std::complex<double>> values;  ///< [m + highest][felt at][force at]

    const std::complex<double>& at(int order, std::size_t felt, std::size_t force) const {
        return values[(static_cast<std::size_t>(order + highest) * wheels + felt) * wheels + force];
    }
};

/// The load e^{ik(x − x_j)}·e^{iω'τ}, ω' = ω − kv, on an infinite rail over equal seats at every spacing L (a seat at x
/// = 0 when t = 0) moves it by e^{ik(x − x_j)}·Σ_m p_m·e^{2πimx/L}; read at x_i + vt:
///   R_ij,m = e^{2πim·x_i/L}·1/2π ∫ p_m(k)·e^{ik(x_i − x_j)} dk,  p_m = δ_m0/D_0 − K/(L·D_0·D_m·(1 + K·Σ_n 1/(L·D_n))),
/// D_n = D(k + 2πn/L, ω') the dynamic stiffness of the free rail and K(ω') that of a seat. Nothing is smeared and no
/// speed is small; as in Hoang, Duhamel & Foret (2014, Int. J. Mech. Sci. 83) for constant loads. Trapezoidal rule,
/// periodic images below 1e-5. `pad_stiffness_n_per_m`: K0 of every pad. `frequency_hz` > 0, `speed_m_per_s` > 0 and
/// below the critical speed, `highest` ≥ 0.
RollingReceptance rolling_receptance(const TrackParameters& track, double pad_stiffness_n_per_m,
                                     const std::vector<double>& wheels_m, double speed_m_per_s, double frequency_hz,
                                     int highest, const TrackModifiers& modifiers = {});

/// The mean over a bay of the sum of all pad forces per unit force at a rolling wheel: what does not move on with it,
/// K/(L·D_0·(1 + K·Σ_n 1/(L·D_n))) at k = 0. ω > 0 in rad/s.
lanes::Complex rolling_trackbed(const TrackParameters& track, double pad_stiffness_n_per_m, lanes::Real omega,
                                const TrackModifiers& modifiers = {});

}  // namespace railpem::track

#pragma once

#include <array>
#include <vector>

#include "pem/case_parameters.hpp"
#include "simulate/march/options.hpp"
#include "simulate/march/profile.hpp"
#include "simulate/march/travel.hpp"
#include "simulate/world_draws.hpp"

namespace railpem::simulate {

/// A wheel that is not round: amplitude·cos(order·distance/R + phase).
struct WheelWave {
    std::size_t wheel;
    double amplitude_m, cycles_per_m, phase;
};

/// All that comes between wheel and rail, and its fading in at the start of the run-in.
struct Excitation {
    Profile profile;                      ///< met by every wheel, or by wheel 1 when the others have their own
    std::vector<Profile> other_profiles;  ///< of wheels 2 to 4; empty: as wheel 1
    std::vector<Dip> dips;                ///< by position
    double longest_dip_m = 0.0;
    std::array<double, 4> wheel_m;  ///< positions of the wheels from the centre of the car
    std::vector<WheelWave> wheel_waves;
    /// Excess over the supports' own passing: per wheel a period of one bay over the distance travelled; empty: none.
    std::array<std::vector<double>, 4> passing_m;
    double spacing_m = 0.6;
    double start_s = 0.0, ramp_s = 1.0;

    const Profile& profile_of(std::size_t wheel) const {
        return wheel == 0 || other_profiles.empty() ? profile : other_profiles[wheel - 1];
    }

    /// Height between wheel and rail at wheel j (0 to 3), m; positive presses them together.
    double at(std::size_t wheel, double time_s, double distance_m) const;
};

/// Shortest wave of the case that the integrator follows: not shorter than a fifth of a step resolves, m.
double shortest_wavelength_m(const spectra::IrregularityParameters& irregularity, double speed_m_per_s, double step_s);

/// Profile, wheels and phases for a record from `start_s` to `end_s`. `draws`, if given, is told about dips and the
/// rough stretch.
Excitation make_excitation(const pem::CaseParameters& parameters, const Options& options, const Travel& travel,
                           double start_s, double end_s, double step_s, WorldDraws* draws = nullptr);

}  // namespace railpem::simulate

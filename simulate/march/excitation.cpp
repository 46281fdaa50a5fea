#include "simulate/march/excitation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate/march/line_faults.hpp"
#include "simulate/numerics/random_numbers.hpp"

namespace railpem::simulate {

namespace {

using std::numbers::pi;

// Purposes of derived seeds.
constexpr std::uint64_t for_wheels = 3;
constexpr std::uint64_t for_rough = 322;

/// Periodic linear interpolation over one bay; the tables are fine enough (see passing table).
double over_bay(const std::vector<double>& table, double bays) {
    const double place = (bays - std::floor(bays)) * static_cast<double>(table.size());
    const auto i = static_cast<std::size_t>(place) % table.size();
    const double share = place - std::floor(place);
    return table[i] + share * (table[(i + 1) % table.size()] - table[i]);
}

}  // namespace

double Excitation::at(std::size_t wheel, double time_s, double distance_m) const {
    double height = profile_of(wheel).at(distance_m + wheel_m[wheel]);
    if (!dips.empty()) height += height_of_dips(dips, longest_dip_m, distance_m + wheel_m[wheel]);
    for (const WheelWave& wave : wheel_waves)
        if (wave.wheel == wheel)
            height += wave.amplitude_m * std::cos(2.0 * pi * wave.cycles_per_m * distance_m + wave.phase);
    if (!passing_m[wheel].empty()) height += over_bay(passing_m[wheel], distance_m / spacing_m);
    const double share = (time_s - start_s) / ramp_s;
    if (share >= 1.0) return height;
    return share <= 0.0 ? 0.0 : 0.5 * (1.0 - std::cos(pi * share)) * height;
}

double shortest_wavelength_m(const spectra::IrregularityParameters& irregularity, double speed_m_per_s, double step_s) {
    double shortest = 1e9;
    for (const spectra::IrregularityBand& band : irregularity.bands)
        shortest = std::min(shortest, band.shortest_wavelength_m);
    for (const spectra::Corrugation& wave : irregularity.corrugation)
        shortest = std::min(shortest, wave.wavelength_m / (1.0 + 5.0 * wave.relative_bandwidth));
    for (const spectra::RailJoints& joints : irregularity.joints) shortest = std::min(shortest, 0.1 * joints.length_m);
    return std::max(shortest, 5.0 * step_s * speed_m_per_s);
}

namespace {

ProfileRequest profile_request(const pem::CaseParameters& parameters, const Options& options, const Travel& travel,
                               double start_s, double end_s, double step_s) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    ProfileRequest request;
    request.from_m = travel.distance(start_s) + wheels.back() - 1.0;
    request.to_m = travel.distance(end_s) + wheels.front() + 1.0;
    // The automatic length depends on what was asked for, not on how long the sensors' filters ring: the same seed is
    // then the same line, whatever a sensor does.
    constexpr double allowance_s = 1.0;
    const double usual = travel.curve.speed_m_per_s.empty()
                             ? travel.speed_m_per_s * (options.seconds + options.settling_s + allowance_s) +
                                   wheels.front() - wheels.back()
                             : travel.distance(options.seconds + allowance_s) - travel.distance(-options.settling_s) +
                                   wheels.front() - wheels.back();
    request.length_m =
        options.profile_length_m > 0.0 ? options.profile_length_m : std::max(usual, request.to_m - request.from_m);
    request.may_repeat = options.repeat_profile;
    request.shortest_wavelength_m =
        shortest_wavelength_m(parameters.irregularity, highest_speed_m_per_s(travel), step_s);
    request.patch_half_length_m = parameters.contact.patch_half_length_m;
    request.seed = line_seed(options);
    request.own = {options.world.own_irregularity_at_1_m, options.world.own_irregularity_exponent};
    return request;
}

/// The common profile, and for every wheel one with its own share.
void set_profiles(Excitation& excitation, const pem::CaseParameters& parameters, const Options& options,
                  const ProfileRequest& request) {
    excitation.profile = options.measured_profile ? resample_profile(*options.measured_profile, request)
                                                  : draw_profile(parameters.irregularity, request);
    if (request.own.at_1_m <= 0.0) return;
    excitation.other_profiles.assign(3, excitation.profile);
    for (std::size_t wheel = 0; wheel < 4; ++wheel)
        add_own_profile(wheel == 0 ? excitation.profile : excitation.other_profiles[wheel - 1], parameters.irregularity,
                        request, wheel);
}

/// Dips and the rough stretch of an imperfect line, below the record and what precedes it.
void add_line_faults(Excitation& excitation, const Options& options, const Travel& travel, double end_s,
                     WorldDraws* draws) {
    const WorldParameters& world = options.world;
    const double end_m = travel.distance(options.seconds);
    if (world.impacts_per_km > 0.0) {
        const double reach_m = excitation.wheel_m.front() + 2.0 * world.impact_length_m;
        excitation.dips = draw_dips(world, line_seed(options), travel.distance(excitation.start_s) - reach_m,
                                    travel.distance(end_s) + reach_m);
        excitation.longest_dip_m = longest_m(excitation.dips);
    }
    double from = 0.0, to = 0.0;
    if (world.rough_level_db != 0.0 && world.rough_share > 0.0) {
        const double length = world.rough_share * end_m;
        from = (end_m - length) * uniform_at(derived_seed(line_seed(options), for_rough), 0);
        to = from + length;
        roughen(excitation.profile, from, to, world.rough_level_db);
        for (Profile& profile : excitation.other_profiles) roughen(profile, from, to, world.rough_level_db);
    }
    if (!draws) return;
    draws->dips = excitation.dips;
    draws->rough_from_m = from;
    draws->rough_to_m = to;
}

}  // namespace

Excitation make_excitation(const pem::CaseParameters& parameters, const Options& options, const Travel& travel,
                           double start_s, double end_s, double step_s, WorldDraws* draws) {
    Excitation excitation;
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    std::copy(wheels.begin(), wheels.end(), excitation.wheel_m.begin());
    excitation.spacing_m = parameters.track.spacing_m;
    excitation.start_s = start_s;
    excitation.ramp_s = std::max(1e-3, std::min(1.0, 0.5 * options.settling_s));
    set_profiles(excitation, parameters, options, profile_request(parameters, options, travel, start_s, end_s, step_s));
    add_line_faults(excitation, options, travel, end_s, draws);
    const std::uint64_t phases = derived_seed(options.seed, for_wheels);
    for (const pem::WheelOutOfRoundness& wheel : parameters.wheel_out_of_roundness)
        excitation.wheel_waves.push_back({static_cast<std::size_t>(wheel.wheel - 1), wheel.amplitude_m,
                                          wheel.order / (2.0 * pi * parameters.vehicle.wheel_radius_m),
                                          2.0 * pi * uniform_at(phases, excitation.wheel_waves.size())});
    return excitation;
}

}  // namespace railpem::simulate

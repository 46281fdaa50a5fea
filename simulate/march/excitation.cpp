#include "simulate/march/excitation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate/numerics/random_numbers.hpp"

namespace railpem::simulate {

namespace {

using std::numbers::pi;

// Purposes of derived seeds.
constexpr std::uint64_t for_profile = 1;
constexpr std::uint64_t for_travel = 2;
constexpr std::uint64_t for_wheels = 3;

/// Periodic linear interpolation over one bay; the tables are fine enough (see passing table).
double over_bay(const std::vector<double>& table, double bays) {
    const double place = (bays - std::floor(bays)) * static_cast<double>(table.size());
    const auto i = static_cast<std::size_t>(place) % table.size();
    const double share = place - std::floor(place);
    return table[i] + share * (table[(i + 1) % table.size()] - table[i]);
}

}  // namespace

double Travel::distance(double time_s) const {
    double time = time_s;
    for (const Wave& wave : wander) {
        const double omega = 2.0 * pi * wave.frequency_hz;
        time += wave.amplitude / omega * (std::cos(wave.phase) - std::cos(omega * time_s + wave.phase));
    }
    return speed_m_per_s * time;
}

Travel make_travel(double speed_m_per_s, double relative_fluctuation, std::uint64_t seed) {
    Travel travel{.speed_m_per_s = speed_m_per_s, .wander = {}};
    if (relative_fluctuation <= 0.0) return travel;
    constexpr int waves = 6;
    const std::uint64_t own = derived_seed(seed, for_travel);
    for (int i = 0; i < waves; ++i) {
        const double period =
            15.0 * std::pow(80.0 / 15.0, (i + uniform_at(own, 2 * static_cast<std::uint64_t>(i))) / waves);
        travel.wander.push_back({relative_fluctuation * std::sqrt(2.0 / waves), 1.0 / period,
                                 2.0 * pi * uniform_at(own, 2 * static_cast<std::uint64_t>(i) + 1)});
    }
    return travel;
}

double Excitation::at(std::size_t wheel, double time_s, double distance_m) const {
    double height = profile.at(distance_m + wheel_m[wheel]);
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

Excitation make_excitation(const pem::CaseParameters& parameters, const Options& options, const Travel& travel,
                           double start_s, double end_s, double step_s) {
    Excitation excitation;
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    std::copy(wheels.begin(), wheels.end(), excitation.wheel_m.begin());
    excitation.spacing_m = parameters.track.spacing_m;
    excitation.start_s = start_s;
    excitation.ramp_s = std::max(1e-3, std::min(1.0, 0.5 * options.settling_s));
    ProfileRequest request;
    request.from_m = travel.distance(start_s) + wheels.back() - 1.0;
    request.to_m = travel.distance(end_s) + wheels.front() + 1.0;
    // The automatic length depends on what was asked for, not on how long the sensors' filters ring: the same seed is
    // then the same line, whatever a sensor does.
    constexpr double allowance_s = 1.0;
    const double usual =
        travel.speed_m_per_s * (options.seconds + options.settling_s + allowance_s) + wheels.front() - wheels.back();
    request.length_m =
        options.profile_length_m > 0.0 ? options.profile_length_m : std::max(usual, request.to_m - request.from_m);
    request.may_repeat = options.repeat_profile;
    request.shortest_wavelength_m = shortest_wavelength_m(parameters.irregularity, travel.speed_m_per_s, step_s);
    request.patch_half_length_m = parameters.contact.patch_half_length_m;
    request.seed = options.profile_seed.value_or(derived_seed(options.seed, for_profile));
    excitation.profile = options.measured_profile ? resample_profile(*options.measured_profile, request)
                                                  : draw_profile(parameters.irregularity, request);
    const std::uint64_t phases = derived_seed(options.seed, for_wheels);
    for (const pem::WheelOutOfRoundness& wheel : parameters.wheel_out_of_roundness)
        excitation.wheel_waves.push_back({static_cast<std::size_t>(wheel.wheel - 1), wheel.amplitude_m,
                                          wheel.order / (2.0 * pi * parameters.vehicle.wheel_radius_m),
                                          2.0 * pi * uniform_at(phases, excitation.wheel_waves.size())});
    return excitation;
}

}  // namespace railpem::simulate

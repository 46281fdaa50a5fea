#include "pem/case_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "parameters/parameter_error.hpp"
#include "pem/response_names.hpp"

namespace railpem::pem {

using namespace parameters;

namespace {

constexpr double kMostGridLines = 2e6;

}  // namespace

Fields<CaseParameters> case_fields() {
    return {text(&CaseParameters::title, "title", "one line that names the case")};
}

Fields<RunningParameters> running_fields() {
    using R = RunningParameters;
    return {
        numbers(&R::speeds_m_per_s, "speeds_m_per_s", "m/s", {.low = 0.0, .high = 200.0, .low_open = true},
                "one speed or a list")
            .required(),
        number(&R::speed_fluctuation, "speed_fluctuation", "1", between(1e-5, 0.05),
               "relative standard deviation of the speed: the width of every line"),
    };
}

Fields<FrequencyParameters> frequency_fields() {
    using F = FrequencyParameters;
    return {
        number(&F::from_hz, "from_hz", "Hz", positive(), "first frequency line").required(),
        number(&F::to_hz, "to_hz", "Hz", {.low = 0.0, .high = 10000.0, .low_open = true},
               "last frequency line, at most")
            .required(),
        number(&F::step_hz, "step_hz", "Hz", not_negative(),
               "distance of the lines; 0: lines that resolve every peak, chosen by the program"),
    };
}

Fields<SolverParameters> solver_fields() {
    using S = SolverParameters;
    return {
        choice(&S::rail, "rail", {"exact", "modal"},
               "exact: infinite track, nothing truncated; modal: simply supported rail of finite length"),
        integer(&S::modes, "modes", between(1, 5000), "modal only: bending modes of the rail"),
        integer(&S::pads, "pads", between(1, 2001),
                "modal only: number of pads on the finite rail, spread evenly about the centre of the car"),
        boolean(&S::moving, "moving",
                "add what the wheels' motion along the rail changes in its receptance and in the pads' load (off in "
                "the paper)"),
    };
}

Fields<ContactParameters> contact_fields() {
    using C = ContactParameters;
    return {
        number(&C::constant_m_per_n23, "constant_m_per_n23", "m/N^(2/3)", not_negative(),
               "contact constant G; 0: worn tread, 3.86e-8 R^-0.115")
            .of(Nature::contact)
            .tolerance(0.15)
            .source("Zhai, worn profile tread"),
        number(&C::nonlinearity_factor, "nonlinearity_factor", "1", between(0.0, 5.0),
               "share of the Hertz law's nonlinearity that is felt: 0 linear, 1 Hertz"),
        number(&C::patch_half_length_m, "patch_half_length_m", "m", between(0.0, 0.05),
               "half length of the contact patch; 0: a point")
            .source("Remington 1987"),
    };
}

Fields<WheelOutOfRoundness> wheel_out_of_roundness_fields() {
    using W = WheelOutOfRoundness;
    return {
        integer(&W::wheel, "wheel", between(1, 4), "the wheel, counted from the front").required(),
        integer(&W::order, "order", between(1, 60), "waves around the circumference").required(),
        number(&W::amplitude_m, "amplitude_m", "m", not_negative(), "amplitude of the radius deviation").required(),
    };
}

Fields<SleeperPassing> sleeper_passing_fields() {
    return {number(&SleeperPassing::amplitude_factor, "amplitude_factor", "1", between(0.0, 100.0),
                   "0: not modelled; 1: as the case's own compliance over a bay gives")};
}

Fields<DecayRateReference> decay_rate_reference_fields() {
    using D = DecayRateReference;
    return {
        numbers(&D::centre_hz, "centre_hz", "Hz", positive(), "third-octaves, increasing"),
        numbers(&D::ratio, "ratio", "1", positive(), "measured by predicted decay rate, per third-octave"),
        numbers(&D::relative_error, "relative_error", "1", not_negative(), "of the measurement, per third-octave"),
    };
}

Fields<SensorParameters> sensor_fields() {
    using S = SensorParameters;
    return {
        text(&S::channel, "channel", "name of the channel, e.g. axlebox_1").required(),
        number(&S::gain, "gain", "1", any_number(), "gain; negative: inverted"),
        number(&S::resonance_frequency_hz, "resonance_frequency_hz", "Hz", not_negative(),
               "resonance of the mounting; 0: rigid"),
        number(&S::resonance_damping_ratio, "resonance_damping_ratio", "1", between(0.0, 1.0), "its damping ratio")
            .of(Nature::loss),
        number(&S::noise_rms_m_per_s2, "noise_rms_m_per_s2", "m/s^2", not_negative(), "rms of additive noise"),
        number(&S::noise_slope_db_per_octave, "noise_slope_db_per_octave", "dB", between(-20.0, 20.0),
               "slope of the noise spectrum"),
        number(&S::delay_s, "delay_s", "s", between(-10.0, 10.0), "the channel is late by this time"),
    };
}

namespace {

std::vector<double> geometric_start(const FrequencyParameters& grid) {
    constexpr double kPerOctave = 24.0;
    const int intervals = std::max(1, static_cast<int>(std::ceil(kPerOctave * std::log2(grid.to_hz / grid.from_hz))));
    std::vector<double> lines(static_cast<std::size_t>(intervals) + 1);
    for (std::size_t i = 0; i < lines.size(); ++i)
        lines[i] = grid.from_hz * std::pow(grid.to_hz / grid.from_hz, static_cast<double>(i) / intervals);
    lines.back() = grid.to_hz;
    return lines;
}

}  // namespace

std::vector<double> frequency_lines(const FrequencyParameters& grid) {
    if (grid.step_hz == 0.0) return geometric_start(grid);
    // A step that divides the range up to rounding reaches the end of it.
    const std::size_t steps =
        static_cast<std::size_t>(std::floor((grid.to_hz - grid.from_hz) / grid.step_hz * (1.0 + 1e-12) + 1e-9));
    std::vector<double> lines(steps + 1);
    for (std::size_t i = 0; i <= steps; ++i) lines[i] = grid.from_hz + static_cast<double>(i) * grid.step_hz;
    return lines;
}

double wheel_load_n(const CaseParameters& parameters) {
    const track::StaticParameters& statics = parameters.track.statics;
    const vehicle::VehicleParameters& car = parameters.vehicle;
    if (statics.wheel_load_n > 0.0) return statics.wheel_load_n + car.payload_kg * statics.gravity_m_per_s2 / 8.0;
    const double mass = car.body_mass_kg + car.payload_kg + 2.0 * car.bogie_mass_kg + 4.0 * car.wheelset_mass_kg;
    return mass * statics.gravity_m_per_s2 / 8.0;
}

namespace {

void check_modal_length(const CaseParameters& parameters) {
    if (parameters.solver.rail != RailSolution::modal) return;
    const double half = 0.5 * (parameters.solver.pads - 1) * parameters.track.spacing_m;
    const double foremost = vehicle::wheel_positions(parameters.vehicle).front();
    if (foremost > half)
        throw ParameterError(
            "solver.pads", fmt::format("wheel 1 stands at {:g} m, off the track, which ends at {:g} m", foremost, half),
            "more pads, or a shorter vehicle");
}

void check_reference(const DecayRateReference& reference) {
    const std::size_t count = reference.centre_hz.size();
    if (reference.ratio.size() != count || reference.relative_error.size() != count)
        throw ParameterError("decay_rate_reference.ratio",
                             fmt::format("{} ratios and {} errors for {} third-octaves", reference.ratio.size(),
                                         reference.relative_error.size(), count),
                             "one of each per third-octave");
    if (std::adjacent_find(reference.centre_hz.begin(), reference.centre_hz.end(), std::greater_equal<>()) !=
        reference.centre_hz.end())
        throw ParameterError("decay_rate_reference.centre_hz", "the values do not increase",
                             "strictly increasing values");
}

/// A spectrum needs two lines to hold any power.
void check_grid(const FrequencyParameters& grid) {
    if (grid.to_hz < grid.from_hz)
        throw ParameterError("frequency.to_hz", "the frequency grid is empty", "greater than frequency.from_hz");
    const double band = grid.to_hz - grid.from_hz;
    if (band == 0.0)
        throw ParameterError("frequency.to_hz",
                             fmt::format("a single frequency line, {:g} Hz, holds no power: it has no rms", grid.to_hz),
                             "greater than frequency.from_hz");
    if (grid.step_hz == 0.0) return;
    if (band / grid.step_hz > kMostGridLines)
        throw ParameterError("frequency.step_hz",
                             fmt::format("{:.3g} frequency lines are more than two million", band / grid.step_hz),
                             fmt::format("at least {:.3g} Hz, or no step_hz", band / kMostGridLines));
    if (frequency_lines(grid).size() < 2)
        throw ParameterError("frequency.step_hz",
                             fmt::format("the step of {:g} Hz is wider than the band from {:g} to {:g} Hz",
                                         grid.step_hz, grid.from_hz, grid.to_hz),
                             fmt::format("at most {:g} Hz, or no step_hz: then the program chooses the lines", band));
}

/// Every band of wavelengths must turn into frequencies of the grid at this speed: one that does not was meant
/// otherwise.
void check_bands_excite(const CaseParameters& parameters, double speed) {
    const FrequencyParameters& grid = parameters.frequency;
    for (std::size_t i = 0; i < parameters.irregularity.bands.size(); ++i) {
        const spectra::IrregularityBand& band = parameters.irregularity.bands[i];
        const double lowest = speed / band.longest_wavelength_m;
        const double highest = speed / band.shortest_wavelength_m;
        if (highest >= grid.from_hz && lowest <= grid.to_hz) continue;
        throw ParameterError(
            spectra::element_key("band", i) + ".shortest_wavelength_m",
            fmt::format(
                "at {:g} m/s wavelengths of {:g} to {:g} m excite {:g} to {:g} Hz, none of it between {:g} and {:g} Hz",
                speed, band.shortest_wavelength_m, band.longest_wavelength_m, lowest, highest, grid.from_hz,
                grid.to_hz),
            "a band of wavelengths that the speed turns into frequencies of the grid");
    }
}

}  // namespace

void check(const CaseParameters& parameters) {
    for (const SensorParameters& sensor : parameters.sensors)
        if (measured_response(sensor.channel).empty())
            throw ParameterError("sensor.channel", fmt::format("there is no channel '{}'", sensor.channel),
                                 "axlebox_1 … axlebox_4, bogie_1, bogie_2, body_front, body_rear, body_centre");
    vehicle::check(parameters.vehicle);
    track::check(parameters.track);
    spectra::check(parameters.irregularity);
    check_grid(parameters.frequency);
    if (parameters.running.speeds_m_per_s.empty())
        throw ParameterError("running.speeds_m_per_s", "no speed", "at least one speed");
    for (const double speed : parameters.running.speeds_m_per_s) check_bands_excite(parameters, speed);
    check_reference(parameters.decay_rate_reference);
    check_modal_length(parameters);
}

}  // namespace railpem::pem

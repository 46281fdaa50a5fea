#include "simulate/catalogue_effects.hpp"

#include "parameters/parameter_error.hpp"

namespace railpem::simulate {

namespace {

using Values = const HiddenValues&;

HiddenParameter number(std::string name, std::string unit, double low, double high, double standard, std::string says) {
    return {.name = std::move(name), .unit = std::move(unit), .low = low, .high = high, .standard = standard, .is_text = false, .says = std::move(says)};
}

HiddenParameter text(std::string name, std::string says) { return {.name = std::move(name), .unit = "", .is_text = true, .says = std::move(says)}; }

/// The sensor of a channel; a new one where the case has none.
pem::SensorParameters& sensor_of(HiddenTarget target, Values values) {
    const std::string& channel = values.texts.at("channel");
    for (pem::SensorParameters& sensor : target.parameters.sensors)
        if (sensor.channel == channel) return sensor;
    target.parameters.sensors.push_back({.channel = channel});
    return target.parameters.sensors.back();
}

void add_pad_effects(std::vector<HiddenEffect>& list) {
    list.push_back({.id = "pad-frequency-stiffening", .says = "the pad stiffens with frequency", .place = "pad",
                    .parameters = {number("exponent", "1", 0.02, 0.35, 0.15, "k in K0 (f/f0)^k (1 + i tan(pi k/2))")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.track.pads.exponent = v.numbers.at("exponent");
                        t.parameters.track.pads.causal = true;
                    }});
    list.push_back({.id = "pad-preload-stiffening", .says = "the pads under the wheels are stiffer because of the load on them", .place = "pad",
                    .parameters = {number("strength", "1", 0.2, 1.5, 1.0, "share of the preload law")},
                    .apply = [](Values v, HiddenTarget t) { t.parameters.track.pads.preload_strength = v.numbers.at("strength"); }});
    list.push_back({.id = "pad-hysteresis", .says = "the pad dissipates by a loss factor, not by a dashpot", .place = "pad",
                    .parameters = {number("loss_factor", "1", 0.05, 1.0, 0.25, "eta of the flat causal loss")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.track.pads.loss_factor = v.numbers.at("loss_factor");
                        t.parameters.track.pads.loss_law = track::LossLaw::causal;
                    }});
    list.push_back({.id = "failed-fasteners", .says = "some fasteners carry nothing", .place = "pad",
                    .parameters = {number("every", "1", 2, 50, 0, "every n-th seat"), number("fraction", "1", 0.01, 0.5, 0, "share of random seats"),
                                   number("remaining_stiffness_fraction", "1", 0.0, 0.9, 0.0, "what is left there"), number("seed", "1", 0, 2147483647, 1, "draws the random seats")},
                    .apply = [](Values v, HiddenTarget t) {
                        track::FailedFasteners failed;
                        failed.every = static_cast<int>(v.numbers.at("every"));
                        failed.fraction = v.numbers.at("fraction");
                        if (failed.every == 0 && failed.fraction == 0.0) throw parameters::ParameterError("--hide failed-fasteners", "neither every nor fraction is given", "every=N or fraction=SHARE");
                        failed.remaining_stiffness_fraction = v.numbers.at("remaining_stiffness_fraction");
                        failed.seed = static_cast<int>(v.numbers.at("seed"));
                        t.parameters.track.failed_fasteners = {failed};
                    }});
}

void add_rail_and_support_effects(std::vector<HiddenEffect>& list) {
    list.push_back({.id = "rail-shear", .says = "the rail shears and its section rotates", .place = "rail",
                    .parameters = {number("shear_coefficient", "1", 0.34, 0.41, 0.4, "kappa of the Timoshenko beam")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.track.rail.beam = track::Beam::timoshenko;
                        t.parameters.track.rail.shear_coefficient = v.numbers.at("shear_coefficient");
                    }});
    list.push_back({.id = "support-compliance", .says = "there is a mass and a spring under the pads", .place = "support",
                    .parameters = {number("mass_kg", "kg", 20, 2000, 150, "per seat"), number("stiffness_n_per_m", "N/m", 5e6, 5e8, 1e8, "per seat"),
                                   number("damping_n_s_per_m", "N s/m", 0, 1e6, 8e4, "per seat")},
                    .apply = [](Values v, HiddenTarget t) {
                        track::SupportParameters& support = t.parameters.track.support;
                        support.model = track::SupportModel::two_layer;
                        support.mass_kg = v.numbers.at("mass_kg");
                        support.stiffness_n_per_m = v.numbers.at("stiffness_n_per_m");
                        support.damping_n_s_per_m = v.numbers.at("damping_n_s_per_m");
                    }});
    list.push_back({.id = "sleeper-flexibility", .says = "the sleeper bends", .place = "support",
                    .parameters = {number("frequency_hz", "Hz", 60, 250, 130, "free-free"), number("loss_factor", "1", 0.005, 0.2, 0.05, "of the mode"),
                                   number("modal_mass_kg", "kg", 20, 300, 80, "per seat, for unit displacement there")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.track.support.bending_modes.push_back({v.numbers.at("frequency_hz"), v.numbers.at("loss_factor"), v.numbers.at("modal_mass_kg")});
                    }});
    list.push_back({.id = "rail-damper", .says = "tuned masses hang on the rail", .place = "rail",
                    .parameters = {number("mass_kg_per_m", "kg/m", 2, 40, 15, "per metre of rail"), number("frequency_hz", "Hz", 30, 2000, 120, "on a fixed rail"),
                                   number("loss_factor", "1", 0.05, 1.0, 0.35, "of its elastomer")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.track.rail_dampers.push_back({v.numbers.at("mass_kg_per_m"), v.numbers.at("frequency_hz"), v.numbers.at("loss_factor")});
                    }});
}

void add_irregularity_effects(std::vector<HiddenEffect>& list) {
    list.push_back({.id = "sleeper-passing", .says = "supports are felt more than the case says", .place = "irregularity",
                    .parameters = {number("amplitude_factor", "1", 0.0, 20.0, 3.0, "over the case's own")},
                    .apply = [](Values v, HiddenTarget t) { t.parameters.sleeper_passing.amplitude_factor = v.numbers.at("amplitude_factor"); }});
    list.push_back({.id = "rail-corrugation", .says = "the rail is corrugated", .place = "irregularity",
                    .parameters = {number("wavelength_m", "m", 0.02, 3.0, 0.3, "of the corrugation"), number("relative_bandwidth", "1", 0.005, 0.5, 0.05, "standard deviation over mean of its spatial frequency"),
                                   number("rms_m", "m", 1e-6, 5e-4, 5e-5, "rms height")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.irregularity.corrugation.push_back({v.numbers.at("wavelength_m"), v.numbers.at("relative_bandwidth"), v.numbers.at("rms_m")});
                    }});
    list.push_back({.id = "rail-joints", .says = "joints or dipped welds at a regular distance", .place = "irregularity",
                    .parameters = {number("spacing_m", "m", 5, 120, 25, "distance"), number("depth_m", "m", 5e-5, 5e-3, 5e-4, "depth of the dip"), number("length_m", "m", 0.05, 2, 0.5, "its length")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.irregularity.joints.push_back({v.numbers.at("spacing_m"), v.numbers.at("depth_m"), v.numbers.at("length_m")});
                    }});
    list.push_back({.id = "irregularity-spectrum", .says = "the track is rougher, smoother or differently shaped than believed", .place = "irregularity",
                    .parameters = {number("level_db", "dB", -20, 20, 0, "at a wavelength of 3 m"), number("slope_db_per_octave", "dB", -6, 6, 0, "per octave of wavelength")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.irregularity.level_db += v.numbers.at("level_db");
                        t.parameters.irregularity.slope_db_per_octave += v.numbers.at("slope_db_per_octave");
                    }});
    list.push_back({.id = "wheel-out-of-roundness", .says = "a wheel is not round", .place = "wheel",
                    .parameters = {number("wheel", "1", 1, 4, 1, "from the front"), number("order", "1", 1, 60, 3, "waves around it"), number("amplitude_m", "m", 1e-6, 1e-3, 1e-4, "of the radius")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.wheel_out_of_roundness.push_back({static_cast<int>(v.numbers.at("wheel")), static_cast<int>(v.numbers.at("order")), v.numbers.at("amplitude_m")});
                    }});
}

void add_vehicle_effects(std::vector<HiddenEffect>& list) {
    list.push_back({.id = "body-bending", .says = "the car body bends", .place = "body",
                    .parameters = {number("frequency_hz", "Hz", 6, 16, 9.5, "first free-free mode"), number("damping_ratio", "1", 0.002, 0.1, 0.015, "of the mode"),
                                   number("modal_mass_kg", "kg", 2000, 40000, 9000, "whole body, for 1 at the centre"), number("shape_at_pivots", "1", -1, 0, -0.35, "over the pivots")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.vehicle.body_bending = {{v.numbers.at("frequency_hz"), v.numbers.at("damping_ratio"), v.numbers.at("modal_mass_kg"), v.numbers.at("shape_at_pivots")}};
                    }});
    list.push_back({.id = "wheelset-bending", .says = "the axle bends", .place = "wheel",
                    .parameters = {number("frequency_hz", "Hz", 50, 110, 80, "of the free wheelset"), number("damping_ratio", "1", 0.002, 0.1, 0.01, "of the mode"),
                                   number("modal_mass_kg", "kg", 100, 3000, 600, "whole wheelset")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.vehicle.wheelset_bending = {{v.numbers.at("frequency_hz"), v.numbers.at("damping_ratio"), v.numbers.at("modal_mass_kg")}};
                    }});
    list.push_back({.id = "bogie-mounted-mass", .says = "equipment hangs elastically on the bogie frames", .place = "bogie",
                    .parameters = {number("mass_kg", "kg", 50, 2000, 400, "per bogie"), number("frequency_hz", "Hz", 5, 80, 20, "on a fixed frame"), number("damping_ratio", "1", 0.01, 0.5, 0.1, "of its mounting"),
                                   number("position_m", "m", -2, 2, 0, "from the bogie centre")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.vehicle.bogie_mounted_masses.push_back({v.numbers.at("mass_kg"), v.numbers.at("frequency_hz"), v.numbers.at("damping_ratio"), v.numbers.at("position_m")});
                    }});
    list.push_back({.id = "primary-damper-series-stiffness", .says = "the primary damper acts through a spring", .place = "primary",
                    .parameters = {number("stiffness_n_per_m", "N/m", 1e5, 1e8, 5e6, "in series with the damper")},
                    .apply = [](Values v, HiddenTarget t) { t.parameters.vehicle.primary.damper_series_stiffness_n_per_m = v.numbers.at("stiffness_n_per_m"); }});
    list.push_back({.id = "secondary-damper-series-stiffness", .says = "the secondary damper acts through a spring", .place = "secondary",
                    .parameters = {number("stiffness_n_per_m", "N/m", 1e5, 1e8, 3e6, "in series with the damper")},
                    .apply = [](Values v, HiddenTarget t) { t.parameters.vehicle.secondary.damper_series_stiffness_n_per_m = v.numbers.at("stiffness_n_per_m"); }});
    list.push_back({.id = "suspension-friction", .says = "dry friction: damping that depends on the level", .place = "primary or secondary",
                    .parameters = {text("stage", "primary or secondary"), number("force_n", "N", 50, 30000, 1500, "per element and rail side")},
                    .apply = [](Values v, HiddenTarget t) {
                        const std::string& stage = v.texts.at("stage");
                        if (stage != "primary" && stage != "secondary") throw parameters::ParameterError("--hide suspension-friction:stage", "no stage \"" + stage + "\"", "primary, secondary");
                        (stage == "primary" ? t.parameters.vehicle.primary : t.parameters.vehicle.secondary).friction_force_n += v.numbers.at("force_n");
                    }});
    list.push_back({.id = "contact-nonlinearity", .says = "the contact opens or stiffens more than the case says", .place = "contact",
                    .parameters = {number("factor", "1", 0.0, 5.0, 2.0, "share of the Hertz law's nonlinearity")},
                    .apply = [](Values v, HiddenTarget t) { t.parameters.contact.nonlinearity_factor = v.numbers.at("factor"); }});
    list.push_back({.id = "contact-filter", .says = "the contact patch averages short waves", .place = "contact",
                    .parameters = {number("patch_half_length_m", "m", 0.003, 0.009, 0.006, "half length of the patch")},
                    .apply = [](Values v, HiddenTarget t) { t.parameters.contact.patch_half_length_m = v.numbers.at("patch_half_length_m"); }});
}

void add_sensor_effects(std::vector<HiddenEffect>& list) {
    const HiddenParameter channel = text("channel", "axlebox_1 to axlebox_4, bogie_1, bogie_2, body_front, body_rear, body_centre");
    list.push_back({.id = "sensor-gain", .says = "a channel reads too high or too low, or is inverted", .place = "sensor",
                    .parameters = {channel, number("gain", "1", -10, 10, 1.1, "negative: inverted")},
                    .apply = [](Values v, HiddenTarget t) { sensor_of(t, v).gain *= v.numbers.at("gain"); }});
    list.push_back({.id = "sensor-resonance", .says = "a sensor mount resonates", .place = "sensor",
                    .parameters = {channel, number("frequency_hz", "Hz", 10, 1000, 150, "of the mount"), number("damping_ratio", "1", 0.005, 0.7, 0.05, "of the mount")},
                    .apply = [](Values v, HiddenTarget t) {
                        pem::SensorParameters& sensor = sensor_of(t, v);
                        sensor.resonance_frequency_hz = v.numbers.at("frequency_hz");
                        sensor.resonance_damping_ratio = v.numbers.at("damping_ratio");
                    }});
    list.push_back({.id = "sensor-noise", .says = "noise, drift or 1/f on a channel", .place = "sensor",
                    .parameters = {channel, number("rms_m_per_s2", "m/s^2", 1e-6, 100, 0.1, "of the noise"), number("slope_db_per_octave", "dB", -12, 6, 0, "of its spectrum")},
                    .apply = [](Values v, HiddenTarget t) {
                        pem::SensorParameters& sensor = sensor_of(t, v);
                        sensor.noise_rms_m_per_s2 = v.numbers.at("rms_m_per_s2");
                        sensor.noise_slope_db_per_octave = v.numbers.at("slope_db_per_octave");
                    }});
    list.push_back({.id = "timing-skew", .says = "a channel is shifted in time", .place = "sensor",
                    .parameters = {channel, number("delay_s", "s", -1, 1, 0.005, "positive: late")},
                    .apply = [](Values v, HiddenTarget t) { sensor_of(t, v).delay_s += v.numbers.at("delay_s"); }});
    list.push_back({.id = "parameter-error", .says = "nothing is missing: a believed value is wrong", .place = "where it belongs",
                    .parameters = {text("parameter", "dotted key of the case"), number("factor", "1", 0.1, 10, 1.3, "true over believed value")},
                    .apply = [](Values v, HiddenTarget t) {
                        if (!t.scale) throw parameters::ParameterError("--hide parameter-error", "the keys of the case are not known here", "another effect");
                        t.scale(t.parameters, v.texts.at("parameter"), v.numbers.at("factor"));
                    }});
}

}  // namespace

std::vector<HiddenEffect> catalogue_effects() {
    std::vector<HiddenEffect> list;
    add_pad_effects(list);
    add_rail_and_support_effects(list);
    add_irregularity_effects(list);
    add_vehicle_effects(list);
    add_sensor_effects(list);
    return list;
}

}  // namespace railpem::simulate

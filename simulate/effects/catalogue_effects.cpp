#include "simulate/effects/catalogue_effects.hpp"

#include "parameters/parameter_error.hpp"

namespace railpem::simulate {

HiddenParameter number_parameter(std::string name, std::string unit, double low, double high, double standard,
                                 std::string says) {
    return {.name = std::move(name),
            .unit = std::move(unit),
            .low = low,
            .high = high,
            .standard = standard,
            .is_text = false,
            .says = std::move(says)};
}

namespace {

using Values = const HiddenValues&;

HiddenParameter text(std::string name, std::string says) {
    return {.name = std::move(name), .unit = "", .is_text = true, .says = std::move(says)};
}

/// The sensor of a channel; a new one where the case has none.
pem::SensorParameters& sensor_of(HiddenTarget target, Values values) {
    const std::string& channel = values.texts.at("channel");
    for (pem::SensorParameters& sensor : target.parameters.sensors)
        if (sensor.channel == channel) return sensor;
    target.parameters.sensors.push_back({.channel = channel});
    return target.parameters.sensors.back();
}

void add_vehicle_effects(std::vector<HiddenEffect>& list) {
    list.push_back(
        {.id = "body-bending",
         .says = "the car body bends",
         .place = "body",
         .parameters = {number_parameter("frequency_hz", "Hz", 6, 16, 9.5, "first free-free mode"),
                        number_parameter("damping_ratio", "1", 0.002, 0.1, 0.015, "of the mode"),
                        number_parameter("modal_mass_kg", "kg", 2000, 40000, 9000, "whole body, for 1 at the centre"),
                        number_parameter("shape_at_pivots", "1", -1, 0, -0.35, "over the pivots")},
         .apply = [](Values v, HiddenTarget t) {
             t.parameters.vehicle.body_bending = {{v.numbers.at("frequency_hz"), v.numbers.at("damping_ratio"),
                                                   v.numbers.at("modal_mass_kg"), v.numbers.at("shape_at_pivots")}};
         }});
    list.push_back({.id = "wheelset-bending",
                    .says = "the axle bends",
                    .place = "wheel",
                    .parameters = {number_parameter("frequency_hz", "Hz", 50, 110, 80, "of the free wheelset"),
                                   number_parameter("damping_ratio", "1", 0.002, 0.1, 0.01, "of the mode"),
                                   number_parameter("modal_mass_kg", "kg", 100, 3000, 600, "whole wheelset")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.vehicle.wheelset_bending = {{v.numbers.at("frequency_hz"),
                                                                  v.numbers.at("damping_ratio"),
                                                                  v.numbers.at("modal_mass_kg")}};
                    }});
    list.push_back({.id = "bogie-mounted-mass",
                    .says = "equipment hangs elastically on the bogie frames",
                    .place = "bogie",
                    .parameters = {number_parameter("mass_kg", "kg", 50, 2000, 400, "per bogie"),
                                   number_parameter("frequency_hz", "Hz", 5, 80, 20, "on a fixed frame"),
                                   number_parameter("damping_ratio", "1", 0.01, 0.5, 0.1, "of its mounting"),
                                   number_parameter("position_m", "m", -2, 2, 0, "from the bogie centre")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.vehicle.bogie_mounted_masses.push_back(
                            {v.numbers.at("mass_kg"), v.numbers.at("frequency_hz"), v.numbers.at("damping_ratio"),
                             v.numbers.at("position_m")});
                    }});
    list.push_back(
        {.id = "primary-damper-series-stiffness",
         .says = "the primary damper acts through a spring",
         .place = "primary",
         .parameters = {number_parameter("stiffness_n_per_m", "N/m", 1e5, 1e8, 5e6, "in series with the damper")},
         .apply = [](Values v, HiddenTarget t) {
             t.parameters.vehicle.primary.damper_series_stiffness_n_per_m = v.numbers.at("stiffness_n_per_m");
         }});
    list.push_back(
        {.id = "secondary-damper-series-stiffness",
         .says = "the secondary damper acts through a spring",
         .place = "secondary",
         .parameters = {number_parameter("stiffness_n_per_m", "N/m", 1e5, 1e8, 3e6, "in series with the damper")},
         .apply = [](Values v, HiddenTarget t) {
             t.parameters.vehicle.secondary.damper_series_stiffness_n_per_m = v.numbers.at("stiffness_n_per_m");
         }});
    list.push_back(
        {.id = "suspension-friction",
         .says = "dry friction: damping that depends on the level",
         .place = "primary or secondary",
         .parameters = {text("stage", "primary or secondary"),
                        number_parameter("force_n", "N", 50, 30000, 1500, "per element and rail side")},
         .apply = [](Values v, HiddenTarget t) {
             const std::string& stage = v.texts.at("stage");
             if (stage != "primary" && stage != "secondary")
                 throw parameters::ParameterError("--hide suspension-friction:stage", "no stage \"" + stage + "\"",
                                                  "primary, secondary");
             (stage == "primary" ? t.parameters.vehicle.primary : t.parameters.vehicle.secondary).friction_force_n +=
                 v.numbers.at("force_n");
         }});
    list.push_back(
        {.id = "contact-nonlinearity",
         .says = "the contact opens or stiffens more than the case says",
         .place = "contact",
         .parameters = {number_parameter("factor", "1", 0.0, 5.0, 2.0, "share of the Hertz law's nonlinearity")},
         .apply = [](Values v, HiddenTarget t) { t.parameters.contact.nonlinearity_factor = v.numbers.at("factor"); }});
    list.push_back(
        {.id = "contact-filter",
         .says = "the contact patch averages short waves",
         .place = "contact",
         .parameters = {number_parameter("patch_half_length_m", "m", 0.003, 0.009, 0.006, "half length of the patch")},
         .apply = [](Values v, HiddenTarget t) {
             t.parameters.contact.patch_half_length_m = v.numbers.at("patch_half_length_m");
         }});
}

void add_sensor_effects(std::vector<HiddenEffect>& list) {
    const HiddenParameter channel =
        text("channel", "axlebox_1 to axlebox_4, bogie_1, bogie_2, body_front, body_rear, body_centre");
    list.push_back({.id = "sensor-gain",
                    .says = "a channel reads too high or too low, or is inverted",
                    .place = "sensor",
                    .parameters = {channel, number_parameter("gain", "1", -10, 10, 1.1, "negative: inverted")},
                    .apply = [](Values v, HiddenTarget t) { sensor_of(t, v).gain *= v.numbers.at("gain"); }});
    list.push_back({.id = "sensor-resonance",
                    .says = "a sensor mount resonates",
                    .place = "sensor",
                    .parameters = {channel, number_parameter("frequency_hz", "Hz", 10, 1000, 150, "of the mount"),
                                   number_parameter("damping_ratio", "1", 0.005, 0.7, 0.05, "of the mount")},
                    .apply = [](Values v, HiddenTarget t) {
                        pem::SensorParameters& sensor = sensor_of(t, v);
                        sensor.resonance_frequency_hz = v.numbers.at("frequency_hz");
                        sensor.resonance_damping_ratio = v.numbers.at("damping_ratio");
                    }});
    list.push_back({.id = "sensor-noise",
                    .says = "noise, drift or 1/f on a channel",
                    .place = "sensor",
                    .parameters = {channel, number_parameter("rms_m_per_s2", "m/s^2", 1e-6, 100, 0.1, "of the noise"),
                                   number_parameter("slope_db_per_octave", "dB", -12, 6, 0, "of its spectrum")},
                    .apply = [](Values v, HiddenTarget t) {
                        pem::SensorParameters& sensor = sensor_of(t, v);
                        sensor.noise_rms_m_per_s2 = v.numbers.at("rms_m_per_s2");
                        sensor.noise_slope_db_per_octave = v.numbers.at("slope_db_per_octave");
                    }});
    list.push_back({.id = "timing-skew",
                    .says = "a channel is shifted in time",
                    .place = "sensor",
                    .parameters = {channel, number_parameter("delay_s", "s", -1, 1, 0.005, "positive: late")},
                    .apply = [](Values v, HiddenTarget t) { sensor_of(t, v).delay_s += v.numbers.at("delay_s"); }});
    list.push_back({.id = "parameter-error",
                    .says = "nothing is missing: a believed value is wrong",
                    .place = "where it belongs",
                    .parameters = {text("parameter", "dotted key of the case"),
                                   number_parameter("factor", "1", 0.1, 10, 1.3, "true over believed value")},
                    .apply = [](Values v, HiddenTarget t) {
                        if (!t.scale)
                            throw parameters::ParameterError(
                                "--hide parameter-error", "the keys of the case are not known here", "another effect");
                        t.scale(t.parameters, v.texts.at("parameter"), v.numbers.at("factor"));
                    }});
}

}  // namespace

std::vector<HiddenEffect> catalogue_effects() {
    std::vector<HiddenEffect> list;
    add_track_effects(list);
    add_vehicle_effects(list);
    add_sensor_effects(list);
    return list;
}

}  // namespace railpem::simulate

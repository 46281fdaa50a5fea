#include "app/prove/effect_draws.hpp"

namespace railpem::app {

namespace {

constexpr DrawSpacing uniform = DrawSpacing::uniform, logarithmic = DrawSpacing::logarithmic,
                      whole = DrawSpacing::whole;
constexpr DrawMirror either_sign = DrawMirror::sign;

std::vector<EffectDraw> track_draws() {
    return {
        {"pad-frequency-stiffening", {{"exponent", 0.02, 0.35, logarithmic}}, "exponent"},
        {"pad-preload-stiffening", {{"strength", 0.2, 1.5, uniform}}, "strength"},
        {"pad-hysteresis", {{"loss_factor", 0.05, 1.0, logarithmic}}, ""},
        {"rail-shear", {{"shear_coefficient", 0.34, 0.41, uniform}}, ""},
        {"support-compliance",
         {{"mass_kg", 40.0, 500.0, logarithmic},
          {"stiffness_n_per_m", 3e7, 4e8, logarithmic},
          {"damping_n_s_per_m", 2e4, 2e5, logarithmic}},
         "stiffness_n_per_m",
         true},
        {"sleeper-flexibility",
         {{"frequency_hz", 60.0, 200.0, logarithmic},
          {"loss_factor", 0.01, 0.1, logarithmic},
          {"modal_mass_kg", 30.0, 300.0, logarithmic}},
         "modal_mass_kg",
         true},
        // Beyond the 175 Hz that a diagnosis looks at, a damper shows by its mass alone.
        {"rail-damper",
         {{"mass_kg_per_m", 2.0, 40.0, logarithmic},
          {"frequency_hz", 40.0, 250.0, logarithmic},
          {"loss_factor", 0.08, 0.6, logarithmic}},
         "mass_kg_per_m"},
        {"failed-fasteners", {{"every", 2.0, 20.0, whole}, {"remaining_stiffness_fraction", 0.0, 0.6, uniform}}, ""},
        {"failed-fasteners",
         {{"fraction", 0.01, 0.3, logarithmic},
          {"remaining_stiffness_fraction", 0.0, 0.6, uniform},
          {"seed", 1.0, 1e6, whole}},
         ""},
    };
}

std::vector<EffectDraw> irregularity_draws() {
    return {
        {"sleeper-passing",
         {{"amplitude_factor", 0.3, 9.0, logarithmic, DrawMirror::none, 1.0}},
         "amplitude_factor",
         false,
         1.0},
        // The higher the order, the less of it is needed for the same acceleration.
        {"wheel-out-of-roundness",
         {{"wheel", 1.0, 4.0, whole},
          {"order", 1.0, 20.0, whole},
          {"amplitude_m", 1e-5, 6e-4, logarithmic, DrawMirror::none, 0.0, "order", -1.0}},
         "amplitude_m"},
        {"rail-corrugation",
         {{"wavelength_m", 0.15, 1.0, logarithmic},
          {"relative_bandwidth", 0.02, 0.2, logarithmic},
          {"rms_m", 1e-5, 2e-4, logarithmic, DrawMirror::none, 0.0, "wavelength_m", 1.0}},
         "rms_m"},
        {"rail-joints",
         {{"spacing_m", 8.0, 40.0, logarithmic},
          {"depth_m", 1e-4, 2e-3, logarithmic},
          {"length_m", 0.3, 1.5, logarithmic}},
         "depth_m"},
        {"irregularity-spectrum",
         {{"level_db", 2.0, 12.0, logarithmic, either_sign}, {"slope_db_per_octave", -1.5, 1.5, uniform}},
         "level_db"},
    };
}

std::vector<EffectDraw> vehicle_draws() {
    return {
        {"body-bending",
         {{"frequency_hz", 6.5, 14.0, uniform},
          {"damping_ratio", 0.005, 0.05, logarithmic},
          {"modal_mass_kg", 4000.0, 40000.0, logarithmic},
          {"shape_at_pivots", -0.6, -0.2, uniform}},
         "modal_mass_kg",
         true},
        {"wheelset-bending",
         {{"frequency_hz", 52.0, 105.0, uniform},
          {"damping_ratio", 0.004, 0.05, logarithmic},
          {"modal_mass_kg", 300.0, 3000.0, logarithmic}},
         "modal_mass_kg",
         true},
        {"bogie-mounted-mass",
         {{"mass_kg", 50.0, 1500.0, logarithmic},
          {"frequency_hz", 6.0, 60.0, logarithmic},
          {"damping_ratio", 0.02, 0.3, logarithmic}},
         "mass_kg"},
        {"primary-damper-series-stiffness", {{"stiffness_n_per_m", 1e6, 6e7, logarithmic}}, "stiffness_n_per_m", true},
        {"secondary-damper-series-stiffness",
         {{"stiffness_n_per_m", 1e6, 6e7, logarithmic}},
         "stiffness_n_per_m",
         true},
        {"suspension-friction", {{"force_n", 80.0, 5000.0, logarithmic}}, "force_n"},
        {"contact-nonlinearity", {{"factor", 1.3, 5.0, logarithmic}}, "factor", false, 1.0},
        {"contact-filter", {{"patch_half_length_m", 0.003, 0.009, uniform}}, "patch_half_length_m"},
    };
}

std::vector<EffectDraw> outside_vehicle_draws() {
    return {
        {"bogie-coupling",
         {{"stiffness_n_per_m", 5e5, 2e7, logarithmic},
          {"damping_n_s_per_m", 1e3, 1e5, logarithmic},
          {"arm_m", 0.0, 3.0, uniform}},
         "stiffness_n_per_m"},
        {"axle-absorber",
         {{"mass_kg", 20.0, 300.0, logarithmic},
          {"frequency_hz", 20.0, 120.0, logarithmic},
          {"damping_ratio", 0.02, 0.3, logarithmic},
          {"wheel", 0.0, 4.0, whole}},
         "mass_kg"},
        {"guidance-stick-slip",
         {{"force_n", 300.0, 8000.0, logarithmic},
          {"static_to_kinetic", 1.2, 2.5, uniform},
          {"stribeck_velocity_m_per_s", 0.005, 0.05, logarithmic}},
         "force_n"},
        {"body-coupling",
         {{"stiffness_n_per_m", 1e5, 5e6, logarithmic},
          {"damping_n_s_per_m", 1e3, 1e5, logarithmic},
          {"neighbour_mass_kg", 5000.0, 30000.0, logarithmic},
          {"neighbour_frequency_hz", 0.8, 6.0, logarithmic},
          {"neighbour_damping_ratio", 0.05, 0.3, logarithmic},
          {"position_m", 9.0, 12.0, uniform, either_sign}},
         "stiffness_n_per_m"},
        {"secondary-bump-stop",
         {{"stiffness_n_per_m", 1e6, 3e7, logarithmic}, {"gap_m", 2e-4, 5e-3, logarithmic}},
         "gap_m",
         true},
    };
}

std::vector<EffectDraw> merged(const std::vector<std::vector<EffectDraw>>& lists) {
    std::vector<EffectDraw> all;
    for (const std::vector<EffectDraw>& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

}  // namespace

const std::vector<EffectDraw>& physics_draws() {
    static const std::vector<EffectDraw> all = merged({track_draws(), irregularity_draws(), vehicle_draws()});
    return all;
}

const std::vector<EffectDraw>& sensor_draws() {
    static const std::vector<EffectDraw> all{
        {"sensor-gain", {{"gain", 0.01, 0.5, logarithmic, either_sign, 1.0}}, "gain", false, 1.0},
        {"sensor-resonance",
         {{"frequency_hz", 60.0, 400.0, logarithmic}, {"damping_ratio", 0.01, 0.2, logarithmic}},
         "frequency_hz",
         true},
        {"sensor-noise",
         {{"rms_m_per_s2", 0.03, 1.0, logarithmic}, {"slope_db_per_octave", -6.0, 0.0, uniform}},
         "rms_m_per_s2"},
        {"timing-skew", {{"delay_s", 2e-4, 2e-2, logarithmic, either_sign}}, "delay_s"},
    };
    return all;
}

const EffectDraw& parameter_error_draw() {
    static const EffectDraw draw{
        "parameter-error", {{"factor", 1.4, 2.5, logarithmic, DrawMirror::inverse}}, "factor", false, 1.0};
    return draw;
}

const std::vector<EffectDraw>& outside_draws() {
    static const std::vector<EffectDraw> all =
        merged({outside_vehicle_draws(),
                {{"pad-dead-band", {{"gap_m", 5e-5, 1e-3, logarithmic}, {"at_load_n", 1e4, 4e4, uniform}}, "gap_m"},
                 {"wandering-subgrade",
                  {{"mass_kg", 200.0, 3000.0, logarithmic},
                   {"frequency_hz", 20.0, 80.0, logarithmic},
                   {"damping_ratio", 0.05, 0.3, logarithmic},
                   {"variation", 0.1, 0.4, uniform},
                   {"length_m", 50.0, 500.0, logarithmic}},
                  ""}}});
    return all;
}

const EffectDraw* find_draw(const std::string& id) {
    for (const std::vector<EffectDraw>* list : {&physics_draws(), &sensor_draws(), &outside_draws()})
        for (const EffectDraw& draw : *list)
            if (draw.id == id) return &draw;
    return id == parameter_error_draw().id ? &parameter_error_draw() : nullptr;
}

}  // namespace railpem::app

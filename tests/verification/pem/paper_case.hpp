#pragma once
// The paper's cases as data (Wei et al. 2016, Tables 1 to 3), typed in here once more and independent of the case
// files.

#include "pem/case_parameters.hpp"

namespace railpem::tests {

inline constexpr double kPaperSpeed = 80.0 / 3.6;  ///< m/s

inline pem::CaseParameters paper_case(int number) {
    pem::CaseParameters c;
    c.vehicle.body_mass_kg = 38500;
    c.vehicle.body_pitch_inertia_kg_m2 = 2.5e6;
    c.vehicle.bogie_mass_kg = 2980;
    c.vehicle.bogie_pitch_inertia_kg_m2 = 3.6e3;
    c.vehicle.wheelset_mass_kg = 1350;
    c.vehicle.bogie_distance_m = 18.0;
    c.vehicle.wheelbase_m = 2.4;
    c.vehicle.primary = {.stiffness_n_per_m = 2.1e6, .damping_n_s_per_m = 4.9e4};
    c.vehicle.secondary = {.stiffness_n_per_m = 2.5e6, .damping_n_s_per_m = 2.0e5};
    c.track.rail = {.youngs_modulus_pa = 2.06e11, .second_moment_of_area_m4 = 3.22e-5, .mass_kg_per_m = 60.64};
    c.track.pads.static_stiffness_n_per_m = 26.7e6;
    c.track.pads.dynamic_to_static_ratio = 1.4;
    c.track.pads.damping_n_s_per_m = 7.5e4;
    c.track.pads.force_polynomial_n = {-451.8, 5.021e6, 3.368e9, 1.228e11, 4.01e13};
    c.track.pads.exponent = number >= 2 ? 0.15 : 0.0;
    c.track.pads.preload_strength = number >= 3 ? 1.0 : 0.0;
    c.track.statics.wheel_load_n = 80e3;
    c.track.statics.rail_weight_kg_per_m = 60.0;
    if (number == 3) c.track.statics.second_moment_of_area_m4 = 5.24e-6;  // as published
    c.irregularity.bands = {
        {.family = spectra::Family::fra, .shortest_wavelength_m = 1.0, .longest_wavelength_m = 100.0, .fra_class = 6},
        {.family = spectra::Family::power_law,
         .shortest_wavelength_m = 0.1,
         .longest_wavelength_m = 1.0,
         .coefficient_m3 = 0.036e-6,
         .exponent = 3.15}};
    c.running.speeds_m_per_s = {kPaperSpeed};
    return c;
}

}  // namespace railpem::tests

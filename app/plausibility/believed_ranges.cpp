#include "app/plausibility/believed_ranges.hpp"

namespace railpem::app {

// Sources: Andersson, Berg & Stichel 2014 (vehicles), Iwnicki, Handbook of Railway Vehicle Dynamics 2006 (vehicles and
// suspensions), EN 13674-1 (rails), EN 13481 and EN 13146-9 (fastenings), Esveld 2001 and Thompson 2009 (track).
// Ranges go a factor of two or more beyond what these quote.
const std::vector<BelievedRange>& believed_ranges() {
    static const std::vector<BelievedRange> all = {
        {"vehicle.body_mass_kg", 2e3, 2e5, "car bodies weigh 5 to 120 t"},
        {"vehicle.body_pitch_inertia_kg_m2", 1e4, 1e7, "car bodies have 1e5 to 5e6 kg m^2"},
        {"vehicle.bogie_mass_kg", 2e2, 3e4, "bogies weigh 1 to 15 t"},
        {"vehicle.bogie_pitch_inertia_kg_m2", 1e2, 1e5, "bogies have 5e2 to 4e4 kg m^2"},
        {"vehicle.wheelset_mass_kg", 3e2, 6e3, "wheelsets weigh 0.7 to 4 t"},
        {"vehicle.bogie_distance_m", 3.0, 40.0, "bogie centres stand 5 to 25 m apart"},
        {"vehicle.wheelbase_m", 0.8, 6.0, "wheelsets of a bogie stand 1.5 to 4 m apart"},
        {"vehicle.wheel_radius_m", 0.15, 0.7, "wheels have radii of 0.17 to 0.65 m"},
        {"vehicle.payload_kg", 1.0, 1.5e5, "loads weigh up to 100 t"},
        {"vehicle.primary.stiffness_n_per_m", 1e5, 5e7, "primary springs have 0.3 to 10 MN/m per axle box"},
        {"vehicle.primary.damping_n_s_per_m", 5e2, 1e6, "primary dampers have 2 to 100 kN s/m per axle box"},
        {"vehicle.secondary.stiffness_n_per_m", 5e4, 3e7, "secondary springs have 0.15 to 5 MN/m per bogie side"},
        {"vehicle.secondary.damping_n_s_per_m", 5e2, 2e6, "secondary dampers have 5 to 300 kN s/m per bogie side"},
        {"vehicle.primary.damper_series_stiffness_n_per_m", 1e4, 1e9, "bushings have 0.1 to 100 MN/m"},
        {"vehicle.secondary.damper_series_stiffness_n_per_m", 1e4, 1e9, "bushings have 0.1 to 100 MN/m"},
        {"vehicle.primary.friction_force_n", 10.0, 5e4, "a spring stage rubs with some kN at most"},
        {"vehicle.secondary.friction_force_n", 10.0, 5e4, "a spring stage rubs with some kN at most"},
        {"vehicle.body_bending.frequency_hz", 3.0, 40.0, "car bodies first bend at 6 to 20 Hz"},
        {"vehicle.body_bending.modal_mass_kg", 3e2, 1e5, "the mode moves a quarter of the body"},
        {"vehicle.wheelset_bending.frequency_hz", 30.0, 200.0, "axles first bend at 50 to 110 Hz"},
        {"vehicle.wheelset_bending.modal_mass_kg", 50.0, 5e3, "the mode moves half of a wheelset"},
        {"vehicle.bogie_mounted_mass.mass_kg", 10.0, 1e4, "motors and gearboxes weigh 0.2 to 3 t"},
        {"vehicle.bogie_mounted_mass.frequency_hz", 1.0, 200.0, "equipment hangs at 5 to 60 Hz"},
        {"track.spacing_m", 0.3, 1.5, "supports stand 0.5 to 0.8 m apart"},
        {"track.rail.youngs_modulus_pa", 1.5e11, 2.5e11, "steel has 2.0e11 to 2.15e11 Pa"},
        {"track.rail.shear_modulus_pa", 6e10, 1e11, "steel has 7.7e10 to 8.3e10 Pa"},
        {"track.rail.second_moment_of_area_m4", 2e-6, 1e-4, "rails of 20 to 77 kg/m have 2e-6 to 4e-5 m^4"},
        {"track.rail.mass_kg_per_m", 15.0, 150.0, "rails weigh 20 to 77 kg/m"},
        {"track.rail.cross_section_m2", 2e-3, 2e-2, "rails of 20 to 77 kg/m have 2.5e-3 to 1e-2 m^2"},
        {"track.rail.loss_factor", 1e-5, 0.2, "rails have loss factors of 0.01 to 0.02"},
        {"track.pads.static_stiffness_n_per_m", 2e6, 5e9, "rail pads have 10 to 1500 kN/mm"},
        {"track.pads.damping_n_s_per_m", 1e2, 1e6, "rail pads have 5 to 200 kN s/m"},
        {"track.pads.loss_factor", 1e-3, 1.5, "rubber and plastics have 0.05 to 0.5"},
        {"track.support.mass_kg", 5.0, 2e4, "half a sleeper weighs 40 to 200 kg, a slab up to some tonnes per seat"},
        {"track.support.stiffness_n_per_m", 1e6, 5e9, "ballast and mats have 5 to 500 kN/mm per seat"},
        {"track.support.damping_n_s_per_m", 1e2, 2e6, "ballast has 20 to 200 kN s/m per seat"},
        {"track.support.bending_mode.frequency_hz", 20.0, 2000.0, "sleepers first bend at 60 to 150 Hz"},
        {"track.support.bending_mode.modal_mass_kg", 5.0, 1e3, "the mode moves part of a sleeper"},
        {"track.static.clip_preload_n", 5e2, 1e5, "fastenings clamp with 10 to 30 kN per seat"},
        {"track.static.gravity_m_per_s2", 9.7, 9.9, "the earth has 9.78 to 9.83 m/s^2"},
        {"track.static.wheel_load_n", 5e3, 2.5e5, "wheels carry 20 to 175 kN"},
        {"track.static.rail_weight_kg_per_m", 15.0, 150.0, "rails weigh 20 to 77 kg/m"},
        {"track.static.second_moment_of_area_m4", 1e-6, 1e-4, "rails of 20 to 77 kg/m have 2e-6 to 4e-5 m^4"},
        {"track.pads.curve_limit_n", 5e3, 5e5, "fastenings are loaded with 20 to 150 kN"},
        {"track.rail_damper.mass_kg_per_m", 0.5, 60.0, "rail dampers weigh 5 to 25 kg/m"},
        {"track.rail_damper.frequency_hz", 50.0, 5e3, "rail dampers are tuned to 200 to 1500 Hz"},
        {"contact.constant_m_per_n23", 1e-8, 2e-7, "wheels of 0.3 to 0.6 m have 4e-8 to 7e-8 m/N^(2/3)"},
        {"irregularity.band.shortest_wavelength_m", 1e-3, 20.0, "waves that excite a vehicle are 0.01 to 200 m long"},
        {"irregularity.band.longest_wavelength_m", 5e-3, 1e3, "waves that excite a vehicle are 0.01 to 200 m long"},
        {"irregularity.corrugation.rms_m", 1e-7, 1e-3, "corrugations are 1 to 300 um high"},
        {"irregularity.joints.depth_m", 1e-6, 0.03, "dips at joints are 0.1 to 5 mm deep"},
        {"wheel_out_of_roundness.amplitude_m", 1e-7, 5e-3, "wheels are out of round by 1 um to 1 mm"},
        {"running.speeds_m_per_s", 0.5, 120.0, "trains run at up to 100 m/s (360 km/h)"},
    };
    return all;
}

const std::vector<BelievedRange>& believed_figures() {
    static const std::vector<BelievedRange> all = {
        {"wheel load", 5e3, 2.5e5, "wheels carry 20 to 175 kN (axles of 4 to 35 t)"},
        {"mass of the body over that of a bogie", 1.0, 150.0, "bodies weigh 3 to 40 times as much as a bogie"},
        {"mass of a bogie over that of a wheelset", 0.3, 20.0, "bogie frames weigh 1 to 5 times as much as a wheelset"},
        {"radius of gyration of the body over the bogie distance", 0.15, 1.0, "that of a uniform body is about 0.4"},
        {"radius of gyration of a bogie over its wheelbase", 0.1, 1.0, "it is 0.3 to 0.6"},
        {"static deflection of the secondary springs", 2e-3, 0.6, "they settle by 20 to 250 mm under the car body"},
        {"static deflection of the primary springs", 2e-4, 0.3, "they settle by 5 to 80 mm under body and bogies"},
        {"body bounce", 0.5, 3.0, "car bodies bounce at 0.8 to 2.5 Hz"},
        {"bogie bounce", 2.0, 40.0, "bogie frames bounce at 4 to 15 Hz"},
        {"wheel on the track", 15.0, 250.0, "wheels on the track resonate at 25 to 120 Hz"},
        {"largest pad compression", 1e-6, 5e-3, "pads give way by 0.1 to 3 mm under train and clips"},
        {"rms of the irregularity", 1e-8, 0.04, "well kept and bad lines alike have 0.1 to 15 mm"},
        {"rms acceleration of the wheels", 1e-3, 500.0, "axle boxes vibrate with 1 to 100 m/s^2"},
        {"rms acceleration of the body", 1e-5, 10.0, "car bodies vibrate with 0.05 to 1 m/s^2"},
    };
    return all;
}

}  // namespace railpem::app

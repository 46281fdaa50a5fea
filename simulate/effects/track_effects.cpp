#include "simulate/effects/catalogue_effects.hpp"

#include "parameters/parameter_error.hpp"

namespace railpem::simulate {

namespace {

using Values = const HiddenValues&;

void add_pad_effects(std::vector<HiddenEffect>& list) {
    list.push_back(
        {.id = "pad-frequency-stiffening",
         .says = "the pad stiffens with frequency",
         .place = "pad",
         .parameters = {number_parameter("exponent", "1", 0.02, 0.35, 0.15, "k in K0 (f/f0)^k (1 + i tan(pi k/2))")},
         .apply = [](Values v, HiddenTarget t) {
             t.parameters.track.pads.exponent = v.numbers.at("exponent");
             t.parameters.track.pads.causal = true;
         }});
    list.push_back({.id = "pad-preload-stiffening",
                    .says = "the pads under the wheels are stiffer because of the load on them",
                    .place = "pad",
                    .parameters = {number_parameter("strength", "1", 0.2, 1.5, 1.0, "share of the preload law")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.track.pads.preload_strength = v.numbers.at("strength");
                    }});
    list.push_back(
        {.id = "pad-hysteresis",
         .says = "the pad dissipates by a loss factor, not by a dashpot",
         .place = "pad",
         .parameters = {number_parameter("loss_factor", "1", 0.05, 1.0, 0.25, "eta of the flat causal loss")},
         .apply = [](Values v, HiddenTarget t) {
             t.parameters.track.pads.loss_factor = v.numbers.at("loss_factor");
             t.parameters.track.pads.loss_law = track::LossLaw::causal;
         }});
    list.push_back(
        {.id = "failed-fasteners",
         .says = "some fasteners carry nothing",
         .place = "pad",
         .parameters = {number_parameter("every", "1", 2, 50, 0, "every n-th seat"),
                        number_parameter("fraction", "1", 0.01, 0.5, 0, "share of random seats"),
                        number_parameter("remaining_stiffness_fraction", "1", 0.0, 0.9, 0.0, "what is left there"),
                        number_parameter("seed", "1", 0, 2147483647, 1, "draws the random seats")},
         .apply = [](Values v, HiddenTarget t) {
             track::FailedFasteners failed;
             failed.every = static_cast<int>(v.numbers.at("every"));
             failed.fraction = v.numbers.at("fraction");
             if (failed.every == 0 && failed.fraction == 0.0)
                 throw parameters::ParameterError("--hide failed-fasteners", "neither every nor fraction is given",
                                                  "every=N or fraction=SHARE");
             failed.remaining_stiffness_fraction = v.numbers.at("remaining_stiffness_fraction");
             failed.seed = static_cast<int>(v.numbers.at("seed"));
             t.parameters.track.failed_fasteners = {failed};
         }});
}

void add_rail_and_support_effects(std::vector<HiddenEffect>& list) {
    list.push_back(
        {.id = "rail-shear",
         .says = "the rail shears and its section rotates",
         .place = "rail",
         .parameters = {number_parameter("shear_coefficient", "1", 0.34, 0.41, 0.4, "kappa of the Timoshenko beam")},
         .apply = [](Values v, HiddenTarget t) {
             t.parameters.track.rail.beam = track::Beam::timoshenko;
             t.parameters.track.rail.shear_coefficient = v.numbers.at("shear_coefficient");
         }});
    list.push_back({.id = "support-compliance",
                    .says = "there is a mass and a spring under the pads",
                    .place = "support",
                    .parameters = {number_parameter("mass_kg", "kg", 20, 2000, 150, "per seat"),
                                   number_parameter("stiffness_n_per_m", "N/m", 5e6, 5e8, 1e8, "per seat"),
                                   number_parameter("damping_n_s_per_m", "N s/m", 0, 1e6, 8e4, "per seat")},
                    .apply = [](Values v, HiddenTarget t) {
                        track::SupportParameters& support = t.parameters.track.support;
                        support.model = track::SupportModel::two_layer;
                        support.mass_kg = v.numbers.at("mass_kg");
                        support.stiffness_n_per_m = v.numbers.at("stiffness_n_per_m");
                        support.damping_n_s_per_m = v.numbers.at("damping_n_s_per_m");
                    }});
    list.push_back(
        {.id = "sleeper-flexibility",
         .says = "the sleeper bends",
         .place = "support",
         .parameters = {number_parameter("frequency_hz", "Hz", 60, 250, 130, "free-free"),
                        number_parameter("loss_factor", "1", 0.005, 0.2, 0.05, "of the mode"),
                        number_parameter("modal_mass_kg", "kg", 20, 300, 80, "per seat, for unit displacement there")},
         .apply = [](Values v, HiddenTarget t) {
             t.parameters.track.support.bending_modes.push_back(
                 {v.numbers.at("frequency_hz"), v.numbers.at("loss_factor"), v.numbers.at("modal_mass_kg")});
         }});
    list.push_back(
        {.id = "rail-damper",
         .says = "tuned masses hang on the rail",
         .place = "rail",
         .parameters = {number_parameter("mass_kg_per_m", "kg/m", 2, 40, 15, "per metre of rail"),
                        number_parameter("frequency_hz", "Hz", 30, 2000, 120, "on a fixed rail"),
                        number_parameter("loss_factor", "1", 0.05, 1.0, 0.35, "of its dashpot, at its own frequency")},
         .apply = [](Values v, HiddenTarget t) {
             t.parameters.track.rail_dampers.push_back(
                 // what is marched
                 {v.numbers.at("mass_kg_per_m"), v.numbers.at("frequency_hz"), v.numbers.at("loss_factor"), 1.0});
         }});
}

void add_irregularity_effects(std::vector<HiddenEffect>& list) {
    list.push_back({.id = "sleeper-passing",
                    .says = "supports are felt more than the case says",
                    .place = "irregularity",
                    .parameters = {number_parameter("amplitude_factor", "1", 0.0, 20.0, 3.0, "over the case's own")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.sleeper_passing.amplitude_factor = v.numbers.at("amplitude_factor");
                    }});
    list.push_back({.id = "rail-corrugation",
                    .says = "the rail is corrugated",
                    .place = "irregularity",
                    .parameters = {number_parameter("wavelength_m", "m", 0.02, 3.0, 0.3, "of the corrugation"),
                                   number_parameter("relative_bandwidth", "1", 0.005, 0.5, 0.05,
                                                    "standard deviation over mean of its spatial frequency"),
                                   number_parameter("rms_m", "m", 1e-6, 5e-4, 5e-5, "rms height")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.irregularity.corrugation.push_back(
                            {v.numbers.at("wavelength_m"), v.numbers.at("relative_bandwidth"), v.numbers.at("rms_m")});
                    }});
    list.push_back({.id = "rail-joints",
                    .says = "joints or dipped welds at a regular distance",
                    .place = "irregularity",
                    .parameters = {number_parameter("spacing_m", "m", 5, 120, 25, "distance"),
                                   number_parameter("depth_m", "m", 5e-5, 5e-3, 5e-4, "depth of the dip"),
                                   number_parameter("length_m", "m", 0.05, 2, 0.5, "its length")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.irregularity.joints.push_back(
                            {v.numbers.at("spacing_m"), v.numbers.at("depth_m"), v.numbers.at("length_m")});
                    }});
    list.push_back({.id = "irregularity-spectrum",
                    .says = "the track is rougher, smoother or differently shaped than believed",
                    .place = "irregularity",
                    .parameters = {number_parameter("level_db", "dB", -20, 20, 0, "at a wavelength of 3 m"),
                                   number_parameter("slope_db_per_octave", "dB", -6, 6, 0, "per octave of wavelength")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.irregularity.level_db += v.numbers.at("level_db");
                        t.parameters.irregularity.slope_db_per_octave += v.numbers.at("slope_db_per_octave");
                    }});
    list.push_back({.id = "wheel-out-of-roundness",
                    .says = "a wheel is not round",
                    .place = "wheel",
                    .parameters = {number_parameter("wheel", "1", 1, 4, 1, "from the front"),
                                   number_parameter("order", "1", 1, 60, 3, "waves around it"),
                                   number_parameter("amplitude_m", "m", 1e-6, 1e-3, 1e-4, "of the radius")},
                    .apply = [](Values v, HiddenTarget t) {
                        t.parameters.wheel_out_of_roundness.push_back({static_cast<int>(v.numbers.at("wheel")),
                                                                       static_cast<int>(v.numbers.at("order")),
                                                                       v.numbers.at("amplitude_m")});
                    }});
}

}  // namespace

void add_track_effects(std::vector<HiddenEffect>& list) {
    add_pad_effects(list);
    add_rail_and_support_effects(list);
    add_irregularity_effects(list);
}

}  // namespace railpem::simulate

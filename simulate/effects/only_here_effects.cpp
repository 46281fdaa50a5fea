#include "simulate/effects/catalogue_effects.hpp"

namespace railpem::simulate {

namespace {

using Values = const HiddenValues&;

HiddenEffect effect(std::string id, std::string place, std::string says, std::vector<HiddenParameter> parameters,
                    std::function<void(Values, HiddenTarget)> apply) {
    return {.id = std::move(id),
            .says = std::move(says),
            .place = std::move(place),
            .only_here = true,
            .parameters = std::move(parameters),
            .apply = std::move(apply)};
}

void add_in_vehicle(std::vector<HiddenEffect>& list) {
    list.push_back(effect("bogie-coupling", "bogie",
                          "a linkage under the car resists heave and pitch of the bogies against each other",
                          {number_parameter("stiffness_n_per_m", "N/m", 1e5, 2e7, 2e6, "of the linkage"),
                           number_parameter("damping_n_s_per_m", "N s/m", 0, 2e5, 1e4, "of the linkage"),
                           number_parameter("arm_m", "m", 0, 5, 1.5, "from the bogie centres inwards")},
                          [](Values v, HiddenTarget t) {
                              t.only_here.bogie_coupling = {v.numbers.at("stiffness_n_per_m"),
                                                            v.numbers.at("damping_n_s_per_m"), v.numbers.at("arm_m")};
                          }));
    list.push_back(effect("axle-absorber", "wheel", "a tuned absorber sits on the axles",
                          {number_parameter("mass_kg", "kg", 10, 300, 80, "per wheelset"),
                           number_parameter("frequency_hz", "Hz", 15, 150, 45, "on a fixed axle"),
                           number_parameter("damping_ratio", "1", 0.01, 0.5, 0.08, "of the absorber"),
                           number_parameter("wheel", "1", 0, 4, 0, "1 to 4; 0: on every axle")},
                          [](Values v, HiddenTarget t) {
                              t.only_here.axle_absorber = {v.numbers.at("mass_kg"), v.numbers.at("frequency_hz"),
                                                           v.numbers.at("damping_ratio"),
                                                           static_cast<int>(v.numbers.at("wheel"))};
                          }));
    list.push_back(
        effect("guidance-stick-slip", "primary", "the guidance of the axle boxes sticks harder than it slides",
               {number_parameter("force_n", "N", 100, 10000, 1500, "sliding force per axle box"),
                number_parameter("static_to_kinetic", "1", 1.1, 3, 1.6, "sticking over sliding force"),
                number_parameter("stribeck_velocity_m_per_s", "m/s", 0.002, 0.1, 0.01, "over which it falls")},
               [](Values v, HiddenTarget t) {
                   t.only_here.guidance_stick_slip = {v.numbers.at("force_n"), v.numbers.at("static_to_kinetic"),
                                                      v.numbers.at("stribeck_velocity_m_per_s")};
               }));
    list.push_back(
        effect("body-coupling", "body", "a buffer ties the end of the body to the neighbouring car",
               {number_parameter("stiffness_n_per_m", "N/m", 1e4, 1e7, 8e5, "of the buffer"),
                number_parameter("damping_n_s_per_m", "N s/m", 0, 2e5, 1e4, "of the buffer"),
                number_parameter("neighbour_mass_kg", "kg", 2000, 40000, 15000, "that moves with the neighbour's end"),
                number_parameter("neighbour_frequency_hz", "Hz", 0.5, 12, 1.3, "of the neighbour on its suspension"),
                number_parameter("neighbour_damping_ratio", "1", 0.01, 1, 0.15, "of its suspension"),
                number_parameter("position_m", "m", -15, 15, -11, "of the buffer from the body's centre")},
               [](Values v, HiddenTarget t) {
                   t.only_here.body_coupling = {
                       v.numbers.at("stiffness_n_per_m"),       v.numbers.at("damping_n_s_per_m"),
                       v.numbers.at("neighbour_mass_kg"),       v.numbers.at("neighbour_frequency_hz"),
                       v.numbers.at("neighbour_damping_ratio"), v.numbers.at("position_m")};
               }));
    list.push_back(
        effect("secondary-bump-stop", "secondary", "bump stops close beside the secondary springs",
               {number_parameter("stiffness_n_per_m", "N/m", 1e5, 5e7, 5e6, "of the stop"),
                number_parameter("gap_m", "m", 1e-4, 0.03, 0.002, "free travel either way")},
               [](Values v, HiddenTarget t) {
                   t.only_here.secondary_bump_stop = {v.numbers.at("stiffness_n_per_m"), v.numbers.at("gap_m")};
               }));
}

void add_in_track(std::vector<HiddenEffect>& list) {
    list.push_back(effect("pad-dead-band", "pad",
                          "the fastening has play: beyond some load the pad gives before it stiffens again",
                          {number_parameter("gap_m", "m", 2e-5, 2e-3, 3e-4, "of the play"),
                           number_parameter("at_load_n", "N", 0, 8e4, 2e4, "load of the pad at which it begins")},
                          [](Values v, HiddenTarget t) {
                              t.only_here.pad_dead_band = {v.numbers.at("gap_m"), v.numbers.at("at_load_n")};
                          }));
    list.push_back(effect("wandering-subgrade", "support",
                          "the ground resonates at a frequency that wanders along the line",
                          {number_parameter("mass_kg", "kg", 50, 5000, 800, "per seat"),
                           number_parameter("frequency_hz", "Hz", 10, 120, 35, "mean"),
                           number_parameter("damping_ratio", "1", 0.02, 0.6, 0.1, "of the ground"),
                           number_parameter("variation", "1", 0, 0.6, 0.25, "relative amplitude of the wandering"),
                           number_parameter("length_m", "m", 20, 2000, 150, "of one wave of it")},
                          [](Values v, HiddenTarget t) {
                              t.only_here.wandering_subgrade = {v.numbers.at("mass_kg"), v.numbers.at("frequency_hz"),
                                                                v.numbers.at("damping_ratio"),
                                                                v.numbers.at("variation"), v.numbers.at("length_m")};
                          }));
}

}  // namespace

std::vector<HiddenEffect> only_here_effects() {
    std::vector<HiddenEffect> list;
    add_in_vehicle(list);
    add_in_track(list);
    return list;
}

}  // namespace railpem::simulate

// Wheels standing, everything linear: the marched response to a generated profile against the frequency-domain transfer
// functions applied to the same profile. Two programs that share parameters and nothing else.
#include <gtest/gtest.h>

#include "tests/verification/simulate/transfer.hpp"

namespace railpem::tests {
namespace {

struct LinearCase {
    std::string name;
    void (*change)(pem::CaseParameters&);
    /// no band may be off by what a wrong element would do; the step's own damping gives 0.02 dB at the top
    double largest_db = 0.1;
};

std::ostream& operator<<(std::ostream& out, const LinearCase& c) {
    return out << c.name;
}

class Standing : public testing::TestWithParam<LinearCase> {};

TEST_P(Standing, EveryChannelFollowsTheTransferFunctions) {
    pem::CaseParameters c = paper_case(1);
    GetParam().change(c);
    for (const ChannelDifference& d : compare(c, standing_options(c, 8.0))) {
        // 0.05 dB: the project's bound for two independent solutions of one linear model; 0.002 dB was reached
        // everywhere but with the contact patch.
        EXPECT_LT(d.median_db, 0.05) << d.channel;
        EXPECT_LT(d.largest_db, GetParam().largest_db) << d.channel;
        RecordProperty(d.channel + "_median_db", std::to_string(d.median_db));
        if (std::getenv("RAILPEM_PRINT") != nullptr)
            std::printf("%-28s %-10s median %.4f largest %.4f dB\n", GetParam().name.c_str(), d.channel.c_str(),
                        d.median_db, d.largest_db);
    }
}

using Case = pem::CaseParameters;
const std::vector<LinearCase> cases{
    {"Case1", [](Case&) {}},
    {"CausalPads",
     [](Case& c) {
         c.track.pads.exponent = 0.15;
         c.track.pads.causal = true;
     }},
    {"CausalStrongPads",
     [](Case& c) {
         c.track.pads.exponent = 0.35;
         c.track.pads.causal = true;
     }},
    {"PreloadedPads",
     [](Case& c) {
         c.track.pads.preload_strength = 1.0;
         c.track.pads.exponent = 0.15;
         c.track.pads.causal = true;
     }},
    {"PreloadedPadsAsPublished",
     [](Case& c) {
         c.track.pads.preload_strength = 1.0;
         c.track.statics.second_moment_of_area_m4 = 5.24e-6;
     }},
    {"CausalLoss",
     [](Case& c) {
         c.track.pads.loss_factor = 0.3;
         c.track.pads.loss_law = track::LossLaw::causal;
     }},
    {"RailShear", [](Case& c) { c.track.rail.beam = track::Beam::timoshenko; }},
    {"TwoLayers",
     [](Case& c) {
         c.track.support = {.model = track::SupportModel::two_layer,
                            .mass_kg = 150,
                            .stiffness_n_per_m = 8e7,
                            .damping_n_s_per_m = 8e4};
     }},
    {"SleeperMode",
     [](Case& c) {
         c.track.support = {.model = track::SupportModel::two_layer,
                            .mass_kg = 150,
                            .stiffness_n_per_m = 8e7,
                            .damping_n_s_per_m = 8e4};
         c.track.support.bending_modes = {{.frequency_hz = 120, .loss_factor = 0.02, .modal_mass_kg = 80}};
     }},
    {"RailDamper",
     [](Case& c) { c.track.rail_dampers = {{.mass_kg_per_m = 15, .frequency_hz = 500, .loss_factor = 0.35}}; }},
    {"RailDamperWithDashpots",  // within the band, where rubber would not do (0.07 to 0.08 dB): dashpots are marched
     [](Case& c) {
         c.track.rail_dampers = {{.mass_kg_per_m = 15, .frequency_hz = 120, .loss_factor = 0.35, .loss_exponent = 1}};
     },
     0.02},
    {"BodyBending", [](Case& c) { c.vehicle.body_bending = {{}}; }},
    {"BodyBendingWithPayload",
     [](Case& c) {
         c.vehicle.body_bending = {{}};
         c.vehicle.payload_kg = 11000;
     }},
    {"WheelsetBending", [](Case& c) { c.vehicle.wheelset_bending = {{}}; }},
    {"BogieMass",
     [](Case& c) {
         c.vehicle.bogie_mounted_masses = {
             {.mass_kg = 400, .frequency_hz = 20, .damping_ratio = 0.1, .position_m = 0.8}};
     }},
    {"MaxwellDampers",
     [](Case& c) {
         c.vehicle.primary.damper_series_stiffness_n_per_m = 5e6;
         c.vehicle.secondary.damper_series_stiffness_n_per_m = 3e6;
     }},
    {"ContactPatch", [](Case& c) { c.contact.patch_half_length_m = 0.009; }},
    {"BetweenPadsWithPayload",
     [](Case& c) {
         c.track.wheel_offset_m = 0.21;
         c.vehicle.payload_kg = 8000;
         c.vehicle.wheelbase_m = 2.5;
     }},
};

INSTANTIATE_TEST_SUITE_P(LinearEffects, Standing, testing::ValuesIn(cases),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace railpem::tests

// The catalogue screened on recordings drawn with an effect planted: which hypothesis is the most promising after
// retuning.

#include "diagnosis/hypotheses/screen.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr double kScreenSpeed = 80.0 / 3.6;

Synthesised nine(const ObservationOptions& options) {
    return synthesised(paper_believed({"vehicle.body_mass_kg", "vehicle.bogie_mass_kg", "vehicle.wheelset_mass_kg",
                                       "vehicle.primary.stiffness_n_per_m", "vehicle.primary.damping_n_s_per_m",
                                       "vehicle.secondary.stiffness_n_per_m", "vehicle.secondary.damping_n_s_per_m",
                                       "track.pads.static_stiffness_n_per_m", "track.pads.damping_n_s_per_m"}),
                       {kScreenSpeed}, 60.0, nine_channels(), options);
}

struct Planted {
    const char* name;
    EffectInstance instance;
    double low_hz, high_hz;  ///< of the recording
};

Planted planted(const EffectInstance& instance, double low_hz, double high_hz) {
    return {instance.effect.c_str(), instance, low_hz, high_hz};
}

/// Retunes on a drawn recording and screens.
std::vector<std::pair<std::string, double>> ranking(const Synthesised& made) {
    std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    FitOptions options;
    options.iterations = 6;
    const Fit retuned =
        fit(believed_trial(made.believed, made.observations), unknowns, means(unknowns), made.context(), options);
    // One start of every variant is enough for a rank, but all grid points of a frequency are needed to hit its peak.
    const std::vector<Candidate> list = candidates(made.believed, retuned.trial, made.observations).candidates;
    std::vector<std::pair<std::string, double>> ranked;
    for (const Promise& promise : screen(retuned, list, made.context()))
        ranked.emplace_back(label_of(list[promise.candidate].instance), promise.gain);
    return ranked;
}

class PlantedEffect : public testing::TestWithParam<Planted> {};

// Screening decides what is refitted, a handful of effects, not what is named; first or second of some 300 variants is
// what it is for.
TEST_P(PlantedEffect, RanksInFront) {
    const Planted& own = GetParam();
    Synthesised made = nine({.window_s = 1.0, .low_hz = own.low_hz, .high_hz = own.high_hz});
    made.truth.effects.push_back(own.instance);
    made.draw(3);
    const auto ranked = ranking(made);
    std::printf("%s: ", own.name);
    for (std::size_t i = 0; i < 3; ++i) std::printf("%s %.1f; ", ranked[i].first.c_str(), ranked[i].second);
    std::printf("\n");
    std::vector<std::string> in_front;
    for (const auto& [label, gain] : ranked)
        if (std::find(in_front.begin(), in_front.end(), label) == in_front.end() && in_front.size() < 2)
            in_front.push_back(label);
    EXPECT_NE(std::find(in_front.begin(), in_front.end(), label_of(own.instance)), in_front.end())
        << in_front[0] << " and " << in_front[1];
}

std::vector<Planted> plants() {
    static const std::vector<EffectInstance> instances = {
        {.effect = "pad-frequency-stiffening", .values = {{"exponent", 0.15}}, .choices = {}},
        {.effect = "body-bending",
         .values = {{"frequency_hz", 9.5}, {"damping_ratio", 0.02}, {"modal_mass_kg", 12e3}, {"shape_at_pivots", -0.4}},
         .choices = {}},
        {.effect = "primary-damper-series-stiffness", .values = {{"stiffness_n_per_m", 4e7}}, .choices = {}},
        {.effect = "sensor-gain", .values = {{"gain", 1.05}}, .choices = {{"channel", "bogie_1"}}},
        {.effect = "timing-skew", .values = {{"delay_s", 2e-3}}, .choices = {{"channel", "bogie_2"}}},
        {.effect = "wheel-out-of-roundness", .values = {}, .choices = {{"wheel", "2"}, {"order", "3"}}},
        {.effect = "rail-shear", .values = {}, .choices = {}},
        {.effect = "suspension-friction", .values = {}, .choices = {{"stage", "secondary"}}},
    };
    return {planted(instances[0], 4.0, 175.0), planted(instances[1], 4.0, 40.0), planted(instances[2], 4.0, 60.0),
            planted(instances[3], 4.0, 40.0),  planted(instances[4], 4.0, 40.0), planted(instances[5], 4.0, 60.0),
            planted(instances[6], 4.0, 175.0), planted(instances[7], 2.0, 40.0)};
}

INSTANTIATE_TEST_SUITE_P(OfTheCatalogue, PlantedEffect, testing::ValuesIn(plants()),
                         [](const testing::TestParamInfo<Planted>& one) {
                             std::string name = one.param.name;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

// Of a null, one candidate's gain is half a χ² of one degree of freedom: above 12 nats once in a million tries
// (two-sided), so even for several hundred of them, were they independent, once in 2000 nulls.
TEST(Screen, ANullPromisesLittle) {
    Synthesised made = nine({.window_s = 1.0, .low_hz = 4.0, .high_hz = 60.0});
    made.draw(4);
    const auto ranked = ranking(made);
    std::printf("null: best of %zu %s %.1f\n", ranked.size(), ranked[0].first.c_str(), ranked[0].second);
    EXPECT_LT(ranked.front().second, 12.0);
}

}  // namespace
}  // namespace railpem::diagnosis

// What is taken over from a similar prediction must be what would have been computed: every kind of unknown, every
// effect.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/hypotheses/candidates.hpp"
#include "diagnosis/hypotheses/corrections.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

Synthesised world(const std::vector<EffectInstance>& effects) {
    Synthesised made = synthesised(
        paper_believed({"vehicle.bogie_mass_kg", "vehicle.wheelset_mass_kg", "vehicle.primary.stiffness_n_per_m",
                        "vehicle.secondary.damping_n_s_per_m", "contact.constant_m_per_n23",
                        "track.pads.static_stiffness_n_per_m", "track.pads.damping_n_s_per_m"}),
        {20.0}, 40.0, {"body", "bogie_1", "wheel_2"}, kSmall);
    made.believed.numbers.sleeper_passing.amplitude_factor = 1.0;
    made.believed.effects = effects;
    made.truth = believed_trial(made.believed, made.shapes);
    made.draw(1);
    return made;
}

/// Largest difference of two predictions, relative to the channels' own levels.
double difference(const ExpectedSpectra& first, const ExpectedSpectra& second) {
    double largest = 0.0;
    for (std::size_t bin = 0; bin < first.bins(); ++bin)
        for (long i = 0; i < first.matrix(bin).rows(); ++i)
            for (long j = 0; j <= i; ++j)
                largest =
                    std::max(largest, std::abs(first.matrix(bin)(i, j) - second.matrix(bin)(i, j)) /
                                          std::sqrt(second.matrix(bin)(i, i).real() * second.matrix(bin)(j, j).real()));
    return largest;
}

/// The same from the cache and from nothing: their difference, and how far the change itself moves the prediction.
std::pair<double, double> reused(const Synthesised& made, const Predictions& known, const Trial& moved, Reuse reuse) {
    const Observation& o = made.observations[0];
    const pem::CaseParameters parameters = case_of(moved, made.believed, o);
    const auto with = expected_spectra(parameters, moved.speed_m_per_s[0], o.kernel, o.channels, {}, o.expectation,
                                       &known.caches[0], reuse);
    const auto without = expected_spectra(parameters, moved.speed_m_per_s[0], o.kernel, o.channels, {}, o.expectation);
    return {difference(with, without), difference(without, known[0])};
}

std::string node_in_the_middle(const Synthesised& made) {
    return " at " + fmt::format("{:.3g}", correction_nodes({.element = Element::pad}, made.observations)[3]) + " Hz";
}

std::vector<Unknown> all_unknowns(const Synthesised& made) {
    std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    std::erase_if(unknowns, [](const Unknown& u) {
        return u.kind == UnknownKind::noise || u.kind == UnknownKind::flicker || u.kind == UnknownKind::floor;
    });
    for (std::size_t e = 0; e < made.believed.effects.size(); ++e)
        for (const Unknown& unknown : effect_unknowns(made.believed.effects[e], e)) unknowns.push_back(unknown);
    for (const CorrectionPlace& place : correction_places(made.believed, made.observations))
        for (const Unknown& unknown : correction_unknowns(place, made.observations))
            if (unknown.name.find(node_in_the_middle(made)) != std::string::npos) unknowns.push_back(unknown);
    return unknowns;
}

void check_unknowns(const std::vector<EffectInstance>& effects) {
    const Synthesised made = world(effects);
    const Predictions known = predict(made.truth, made.context());
    const bool friction = std::any_of(effects.begin(), effects.end(),
                                      [](const EffectInstance& own) { return own.effect == "suspension-friction"; });
    for (const Unknown& unknown : all_unknowns(made)) {
        Trial moved = made.truth;
        const double start = unknown.kind == UnknownKind::effect ? 0.5 * (unknown.low + unknown.high) : unknown.mean;
        unknown.set(moved, start + 0.1 * unknown.deviation);
        const auto [error, change] = reused(made, known, moved, shared_with(made.truth, unknown));
        // linearising settles to 1e-10, from wherever it starts
        EXPECT_LE(error, friction ? 1e-10 : 1e-12) << unknown.name;
        if (unknown.kind != UnknownKind::correction && unknown.kind != UnknownKind::irregularity) {
            EXPECT_GT(change, 1e-9) << unknown.name << " moves nothing";
        }
    }
}

TEST(Reuse, EveryUnknown) {
    check_unknowns({});
}

TEST(Reuse, EveryUnknownBesideSuspensionFriction) {
    check_unknowns(
        {{.effect = "suspension-friction", .values = {{"force_n", 300.0}}, .choices = {{"stage", "secondary"}}}});
}

TEST(Reuse, EveryUnknownBesideAnEffectOfTheContact) {
    check_unknowns({{.effect = "contact-filter", .values = {{"patch_half_length_m", 0.006}}, .choices = {}}});
}

TEST(Reuse, EveryUnknownBesidePreloadStiffening) {
    check_unknowns({{.effect = "pad-preload-stiffening", .values = {{"strength", 0.5}}, .choices = {}}});
}

void check_effects(const std::vector<EffectInstance>& beside, double tolerance) {
    const Synthesised made = world(beside);
    const Predictions known = predict(made.truth, made.context());
    int tried = 0;
    std::set<std::string> variants;
    for (const Candidate& candidate : candidates(made.believed, made.truth, made.observations).candidates) {
        if (!variants.insert(label_of(candidate.instance)).second) continue;
        for (const EffectInstance& instance : {candidate.probe, candidate.instance}) try {
                Trial moved = made.truth;
                moved.effects.push_back(instance);
                EXPECT_LE(reused(made, known, moved, shared_with(made.truth, instance)).first, tolerance)
                    << label_of(instance);
                ++tried;
            } catch (const parameters::ParameterError&) {  // no value that this case can have
            }
    }
    EXPECT_GT(tried, 60);
}

TEST(Reuse, EveryEffectAsItIsProbedAndAtStrength) {
    check_effects({}, 1e-12);
}

// What a sensor makes of the forces of friction, too; linearising settles to 1e-10.
TEST(Reuse, EveryEffectBesideSuspensionFriction) {
    check_effects(
        {{.effect = "suspension-friction", .values = {{"force_n", 300.0}}, .choices = {{"stage", "primary"}}}}, 1e-10);
}

// Lines and bands of roughness hardly move the damping that friction is taken for: by a twentieth of what they do
// themselves a promise would be off by a tenth.
TEST(Reuse, ProbesLeaveTheLevelWhereItIs) {
    const Synthesised made =
        world({{.effect = "suspension-friction", .values = {{"force_n", 300.0}}, .choices = {{"stage", "primary"}}}});
    const Predictions known = predict(made.truth, made.context());
    std::map<std::string, double> worst;
    for (const Candidate& candidate : candidates(made.believed, made.truth, made.observations).candidates) {
        const Reuse reuse = shared_with_probe(made.truth, candidate.probe);
        if (reuse == shared_with(made.truth, candidate.probe)) continue;
        Trial moved = made.truth;
        moved.effects.push_back(candidate.probe);
        const auto [error, change] = reused(made, known, moved, reuse);
        double& own = worst[candidate.instance.effect];
        own = std::max(own, error / change);
    }
    for (const auto& [effect, own] : worst) std::printf("%s: %.4f\n", effect.c_str(), own);
    EXPECT_EQ(worst.size(), 3U);
    for (const auto& [effect, own] : worst) EXPECT_LT(own, 0.05) << effect;
}

}  // namespace
}  // namespace railpem::diagnosis

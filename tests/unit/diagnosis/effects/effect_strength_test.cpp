// Every effect vanishes with its strength, does something at its typical one, and combines with the others.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pem/coupling/solution.hpp"
#include "pem/coupling/solve_case.hpp"
#include "pem/response_names.hpp"
#include "tests/unit/diagnosis/effect_fixtures.hpp"

namespace railpem::diagnosis {
namespace {

pem::Solution solved(const pem::CaseParameters& c) {
    pem::check(c);
    return pem::solve_case(c, tests::kPaperSpeed, {.threads = 1});
}

/// Largest difference of any spectrum, relative to its value, or to 1e-6 of its peak where the wheels cancel each
/// other.
double difference(const pem::Solution& a, const pem::Solution& b) {
    double largest = 0.0;
    for (std::size_t r = 0; r < pem::response_names().size(); ++r) {
        const std::vector<double> p = pem::response_psd(a, r), q = pem::response_psd(b, r);
        const double floor = 1e-6 * *std::max_element(q.begin(), q.end());
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (!std::isfinite(p[i])) return INFINITY;
            largest = std::max(largest, std::abs(p[i] - q[i]) / std::max(q[i], floor));
        }
    }
    return largest;
}

/// The same for the complex responses to the irregularity, for what spectra do not see.
double complex_difference(const pem::Solution& a, const pem::Solution& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < pem::response_names().size() * a.frequency_hz.size(); ++i)
        largest = std::max(
            largest, std::abs(a.pseudo_response[i] - b.pseudo_response[i]) / (std::abs(b.pseudo_response[i]) + 1e-300));
    return largest;
}

pem::CaseParameters with(const EffectInstance& instance, pem::CaseParameters c) {
    apply(instance, some_numbers(), c, true);
    return c;
}

class EffectStrength : public testing::TestWithParam<std::size_t> {
  protected:
    const Effect& effect() const { return effects()[GetParam()]; }
};

/// Strength 0 is the case without, to 1e-12. Where the effect vanishes at infinity 1e20 times the typical strength
/// stands for it: what is left is of the order of its inverse.
TEST_P(EffectStrength, NothingAtNothing) {
    EffectInstance instance = typical_instance(effect());
    bool fades = false;
    for (const EffectParameter& parameter : effect().parameters) {
        if (!parameter.strength) continue;
        fades = true;
        instance.values[parameter.name] = std::isinf(parameter.nothing) ? 1e20 * parameter.typical : parameter.nothing;
    }
    if (!fades) GTEST_SKIP() << "there or not there; its limit is tested below";
    const pem::CaseParameters believed = believed_case(effect().id);
    EXPECT_LE(difference(solved(with(instance, believed)), solved(believed)), 1e-12);
}

TEST_P(EffectStrength, SomethingWhenTypical) {
    const pem::CaseParameters believed = believed_case(effect().id);
    const pem::Solution a = solved(with(typical_instance(effect()), believed)), b = solved(believed);
    EXPECT_LT(difference(a, b), 1e12);
    const bool phase_only = effect().id == "timing-skew";
    // Some 0.04 dB somewhere; on the smooth track of the case the contact hardly opens, an excess is 0.002 dB.
    EXPECT_GE(phase_only ? complex_difference(a, b) : difference(a, b),
              effect().id == "contact-nonlinearity" ? 1e-4 : 1e-2);
}

/// The ends of every range can be solved as well.
TEST_P(EffectStrength, SolvedAtTheEndsOfItsRange) {
    pem::CaseParameters believed = believed_case(effect().id);
    believed.frequency.step_hz = 20.0;
    const pem::Solution b = solved(believed);
    for (const EffectParameter& parameter : effect().parameters)
        for (const double end : {parameter.low, parameter.high}) {
            EffectInstance instance = typical_instance(effect());
            instance.values[parameter.name] = end;
            pem::CaseParameters c = believed;
            apply(instance, some_numbers(), c);
            EXPECT_LT(difference(solved(c), b), 1e12) << parameter.name << " = " << end;
        }
}

INSTANTIATE_TEST_SUITE_P(Library, EffectStrength, testing::Range<std::size_t>(0, effects().size()),
                         [](const auto& parameter) {
                             std::string name = effects()[parameter.param].id;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

/// The shear coefficient is no strength: the rail shears or not. With a cross-section grown without bounds (stiffness
/// κGA up, rotary inertia mI/A down) the Timoshenko rail is the Euler rail.
TEST(RailShear, LimitOfAnEndlessCrossSection) {
    const pem::CaseParameters believed = believed_case("rail-shear");
    pem::CaseParameters shearing = with({.effect = "rail-shear"}, believed);
    EXPECT_NEAR(shearing.track.rail.cross_section_m2, 60.64 / 7850.0, 1e-12);
    shearing.track.rail.cross_section_m2 *= 1e14;
    EXPECT_LE(difference(solved(shearing), solved(believed)), 1e-12);
}

TEST(RailShear, KeepsAStatedCrossSection) {
    pem::CaseParameters c = believed_case("rail-shear");
    c.track.rail.cross_section_m2 = 6.9e-3;
    EXPECT_EQ(with({.effect = "rail-shear"}, c).track.rail.cross_section_m2, 6.9e-3);
}

/// The loss factor replaces the dashpot, so its limit is the case without a dashpot. It fades in proportion: to first
/// order a loss factor ten times smaller is a difference ten times smaller.
TEST(PadHysteresis, LimitOfNoLoss) {
    pem::CaseParameters undamped = believed_case("pad-hysteresis");
    undamped.track.pads.damping_n_s_per_m = 0.0;
    const auto distance = [&](double loss_factor) {
        const EffectInstance instance{.effect = "pad-hysteresis", .values = {{"loss_factor", loss_factor}}};
        return difference(solved(with(instance, believed_case("pad-hysteresis"))), solved(undamped));
    };
    EXPECT_LE(distance(1e-18), 1e-12);
    EXPECT_NEAR(distance(1e-7) / distance(1e-8), 10.0, 0.1);
}

/// A case with an exponent of its own keeps its form: nothing added, nothing changed, causal or not.
TEST(PadFrequencyStiffening, AddsToTheExponentOfTheCase) {
    const pem::CaseParameters own = tests::paper_case(2);
    const pem::CaseParameters more = with({.effect = "pad-frequency-stiffening", .values = {{"exponent", 0.05}}}, own);
    EXPECT_DOUBLE_EQ(more.track.pads.exponent, 0.20);
    EXPECT_FALSE(more.track.pads.causal);
    EXPECT_TRUE(with({.effect = "pad-frequency-stiffening"}, tests::paper_case(1)).track.pads.causal);
}

TEST(DamperSeriesStiffness, IsInSeriesWithThatOfTheCase) {
    pem::CaseParameters c = tests::paper_case(1);
    const EffectInstance series{.effect = "primary-damper-series-stiffness", .values = {{"stiffness_n_per_m", 6e6}}};
    c = with(series, c);
    EXPECT_DOUBLE_EQ(c.vehicle.primary.damper_series_stiffness_n_per_m, 6e6);
    EXPECT_DOUBLE_EQ(with(series, c).vehicle.primary.damper_series_stiffness_n_per_m, 3e6);
}

/// All of the library at once, listed forwards and backwards: the same case, and it can be solved.
TEST(Effects, CombineInAnyOrder) {
    std::vector<EffectInstance> all;
    for (const Effect& effect : effects()) all.push_back(typical_instance(effect));
    pem::CaseParameters forwards = believed_case(""), backwards = believed_case("");
    apply(all, some_numbers(), forwards);
    std::reverse(all.begin(), all.end());
    apply(all, some_numbers(), backwards);
    const pem::Solution a = solved(forwards), b = solved(backwards);
    EXPECT_LE(difference(a, b), 1e-12);
    EXPECT_GT(a.source_names.size(), 2u);
}

/// Applied one by one the order does not matter either, as long as the sleeper is there before it bends: sensors in
/// particular, whose entries form chains. Sums and products in another order round differently: 1e-11.
TEST(Effects, OneByOneInAnyOrder) {
    std::vector<EffectInstance> list;
    for (const Effect& effect : effects())
        if (effect.id != "parameter-error" && effect.id != "sleeper-flexibility")
            list.push_back(typical_instance(effect));
    for (const char* id : {"sensor-noise", "sensor-gain", "sensor-resonance"})  // a second one on the same channel
        list.push_back(typical_instance(*find_effect(id)));
    pem::CaseParameters forwards = believed_case(""), backwards = believed_case("");
    for (auto i = list.begin(); i != list.end(); ++i) apply(*i, some_numbers(), forwards);
    for (auto i = list.rbegin(); i != list.rend(); ++i) apply(*i, some_numbers(), backwards);
    EXPECT_LE(difference(solved(forwards), solved(backwards)), 1e-11);
}

}  // namespace
}  // namespace railpem::diagnosis

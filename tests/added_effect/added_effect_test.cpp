// Adding an effect takes its description and its physics on both sides, and no other file: everybody who names effects
// knows the one of tree/.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/input_error.hpp"
#include "app/prove/hidden_draw.hpp"
#include "app/schema/hide_option.hpp"
#include "effects/catalogue.hpp"
#include "effects/describe_effects.hpp"
#include "tests/unit/prove/proof_case.hpp"

namespace railpem::app {
namespace {

const std::string kSnow = "snow-on-bogies";

TEST(AddedEffect, StandsInItsRowOfTheCatalogue) {
    std::vector<std::string> ids;
    for (const effects::EffectDescription& effect : effects::catalogue()) ids.push_back(effect.id);
    const auto own = std::find(ids.begin(), ids.end(), kSnow);
    ASSERT_NE(own, ids.end());
    EXPECT_EQ(own[-1], "bogie-mounted-mass");
    EXPECT_EQ(own[1], "primary-damper-series-stiffness");
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
}

TEST(AddedEffect, IsListedAndDescribed) {
    EXPECT_NE(effects_list().find("\nsnow-on-bogies (bogie): snow and ice cling to the bogie frames\n"
                                  "    snow_kg                      20 to 900 kg, default 300: mass on each bogie\n"),
              std::string::npos);
    const std::string page = effects::describe_effects();
    EXPECT_NE(
        page.find("## `snow-on-bogies`\n\nLeft out: snow and ice cling to the bogie frames and make them heavier."),
        std::string::npos);
    EXPECT_NE(page.find("| `snow_kg` | kg | 20 to 900 | 300 | logarithmic | mass on each bogie; fades towards 0 |"),
              std::string::npos);
}

TEST(AddedEffect, IsHiddenByItsName) {
    const pem::CaseParameters believed = ProofCase().file.parameters;
    const CaseWithHidden with = hide_in_case(believed, read_hide_options({kSnow + ":snow_kg=250"}, false));
    EXPECT_EQ(with.parameters.vehicle.bogie_mass_kg, believed.vehicle.bogie_mass_kg + 250.0);
    EXPECT_THROW(read_hide_options({kSnow + ":snow_kg=1000"}, false), InputError) << "out of its range";
    try {
        read_hide_options({"snow-on-bogie"}, false);
        FAIL() << "no such effect";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(kSnow), std::string::npos) << error.what();
    }
}

TEST(AddedEffect, IsReadFromACaseAndIsAHypothesis) {
    const std::string text(proved_case());
    const double mass = parse_case("case.toml", text, {}).parameters.vehicle.bogie_mass_kg;
    const CaseFile file = parse_case("case.toml", text + "\n[[effect]]\nid = \"snow-on-bogies\"\nsnow_kg = 120\n", {});
    EXPECT_EQ(file.parameters.vehicle.bogie_mass_kg, mass + 120.0);
    const diagnosis::Effect* effect = diagnosis::find_effect(kSnow);
    ASSERT_NE(effect, nullptr);
    EXPECT_EQ(element_of(*effect, {.effect = kSnow}), diagnosis::Element::bogie);
    EXPECT_EQ(value_of(*effect, {.effect = kSnow}, "snow_kg"), 300.0);
}

TEST(AddedEffect, IsDrawnByTheProof) {
    const ProofCase proof;
    const std::vector<std::string> ids = drawable_effects(proof.file, TrialKind::single);
    EXPECT_EQ(std::count(ids.begin(), ids.end(), kSnow), 1);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        DrawStream stream(seed);
        const simulate::Hidden hidden = draw_effect(kSnow, proof.file, proof.believed, {}, stream);
        EXPECT_GE(hidden.values.numbers.at("snow_kg"), 50.0);
        EXPECT_LE(hidden.values.numbers.at("snow_kg"), 800.0);
        EXPECT_EQ(true_places({.hidden = {hidden}}), std::vector<std::string>{"bogie"});
    }
}

}  // namespace
}  // namespace railpem::app

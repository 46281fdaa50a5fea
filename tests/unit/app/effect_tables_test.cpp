#include "app/schema/effect_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/schema/case_file.hpp"
#include "app/schema/case_schema.hpp"

namespace railpem::app {
namespace {

std::string case_text(const std::string& effects = "") {
    std::ifstream stream(std::filesystem::path(RAILPEM_SOURCE_DIR) / "cases/wei2016/case1.toml");
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str() + effects;
}

CaseFile read(const std::string& effects, const std::vector<std::string>& options = {}) {
    return parse_case("case.toml", case_text(effects), options);
}

TEST(EffectTables, AreAppliedToTheRestOfTheCase) {
    const CaseFile file = read(
        "\n[[effect]]\nid = \"pad-frequency-stiffening\"\nexponent = 0.12\n"
        "\n[[effect]]\nid = \"wheel-out-of-roundness\"\nwheel = 3\norder = 7\n");
    EXPECT_EQ(file.parameters.track.pads.exponent, 0.12);
    EXPECT_TRUE(file.parameters.track.pads.causal);
    ASSERT_EQ(file.parameters.wheel_out_of_roundness.size(), 1u);
    EXPECT_EQ(file.parameters.wheel_out_of_roundness[0].wheel, 3);
    EXPECT_EQ(file.parameters.wheel_out_of_roundness[0].order, 7);
    EXPECT_EQ(file.parameters.wheel_out_of_roundness[0].amplitude_m, 50e-6) << "typical";
    EXPECT_EQ(file.without_effects.track.pads.exponent, 0.0);
    EXPECT_TRUE(file.without_effects.wheel_out_of_roundness.empty());
    ASSERT_EQ(file.effects.size(), 2u);
    EXPECT_EQ(file.effects[0].values, (std::map<std::string, double>{{"exponent", 0.12}}));
    EXPECT_EQ(file.effects[1].choices, (std::map<std::string, std::string>{{"wheel", "3"}, {"order", "7"}}));
}

TEST(EffectTables, WithoutThemTheCaseIsItself) {
    const CaseFile file = read("");
    EXPECT_TRUE(file.effects.empty());
    EXPECT_EQ(write_case(file.parameters), write_case(file.without_effects));
}

/// A sleeper may bend in a table that stands before the one that brings the sleeper.
TEST(EffectTables, InAnyOrder) {
    const CaseFile file =
        read("\n[[effect]]\nid = \"sleeper-flexibility\"\n\n[[effect]]\nid = \"support-compliance\"\n");
    EXPECT_EQ(file.parameters.track.support.model, track::SupportModel::two_layer);
    EXPECT_EQ(file.parameters.track.support.bending_modes.size(), 1u);
}

TEST(EffectTables, WrongValuesArePutRightFirst) {
    const CaseFile file = read(
        "\n[[effect]]\nid = \"irregularity-spectrum\"\nlevel_db = 3.0\n"
        "\n[[effect]]\nid = \"parameter-error\"\nparameter = \"irregularity.band.2.exponent\"\nfactor = 1.1\n"
        "\n[[effect]]\nid = \"parameter-error\"\nparameter = \"vehicle.bogie_mass_kg\"\nfactor = 0.8\n");
    EXPECT_DOUBLE_EQ(file.parameters.irregularity.bands[1].exponent, 1.1 * 3.15);
    EXPECT_DOUBLE_EQ(file.parameters.vehicle.bogie_mass_kg, 0.8 * 2980.0);
    EXPECT_EQ(file.parameters.irregularity.level_db, 3.0);
}

/// Every effect of the library, with all it can state at odd values, is written and read back to the same bits.
TEST(EffectTables, ReadBackToTheSameBits) {
    for (const diagnosis::Effect& effect : diagnosis::effects()) {
        diagnosis::EffectInstance instance{.effect = effect.id};
        for (const diagnosis::EffectChoice& choice : effect.choices)
            instance.choices[choice.name] = choice.options.empty() ? "vehicle.bogie_mass_kg" : choice.options.back();
        for (const diagnosis::EffectParameter& parameter : effect.parameters)
            if (effect.choices.empty() || effect.choices.front().replaces != parameter.name)
                instance.values[parameter.name] = parameter.low + (parameter.high - parameter.low) / 3.0;
        const Document document = parse_document("written.toml", write_effects({instance, instance}));
        const std::vector<diagnosis::EffectInstance> read = read_effects(document, case_schema());
        ASSERT_EQ(read.size(), 2u) << effect.id;
        for (const diagnosis::EffectInstance& back : read) {
            EXPECT_EQ(back.effect, effect.id);
            EXPECT_EQ(back.values, instance.values) << effect.id;
            EXPECT_EQ(back.choices, instance.choices) << effect.id;
        }
    }
}

TEST(EffectTables, AreKeptWhenTheCaseIsWritten) {
    const CaseFile file = read("\n[[effect]]\nid = \"failed-fasteners\"\nevery = 8\n");
    const std::string text = write_case(file.without_effects, file.effects);
    EXPECT_NE(text.find("[[effect]]\nid = \"failed-fasteners\"\nevery = 8\n"), std::string::npos);
    const CaseFile again = parse_case("again.toml", text, {});
    EXPECT_EQ(write_case(again.parameters), write_case(file.parameters));
    EXPECT_EQ(write_case(again.without_effects, again.effects), text);
}

TEST(EffectTables, OptionsReachThem) {
    EXPECT_EQ(read("\n[[effect]]\nid = \"rail-shear\"\n", {"effect.shear_coefficient=0.35"})
                  .parameters.track.rail.shear_coefficient,
              0.35);
    const CaseFile added = read("", {"effect.id=suspension-friction", "effect.stage=secondary", "effect[1].force_n=900",
                                     "effect[2].id=timing-skew", "effect[2].channel=bogie_2"});
    EXPECT_EQ(added.parameters.vehicle.secondary.friction_force_n, 900.0);
    ASSERT_EQ(added.parameters.sensors.size(), 1u);
    EXPECT_EQ(added.parameters.sensors[0].delay_s, 2e-3);
}

TEST(ParameterAccess, HoldsPhysicsOnly) {
    const pem::CaseParameters parameters = read("").parameters;
    for (const std::string& key : parameter_access(parameters).keys) {
        EXPECT_FALSE(key.starts_with("frequency.")) << key;
        EXPECT_FALSE(key.starts_with("solver.")) << key;
    }
}

}  // namespace
}  // namespace railpem::app

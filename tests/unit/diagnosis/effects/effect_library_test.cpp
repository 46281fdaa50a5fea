// The library holds the catalogue: identifiers, parameter names and ranges that the outside of the program fixes.

#include <gtest/gtest.h>

#include <set>

#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {
namespace {

struct Row {
    const char* id;
    std::vector<std::string> names;  ///< parameters and choices
    const char* element;
};

/// The catalogue, typed in here once more.
const std::vector<Row>& catalogue() {
    static const std::vector<Row> rows = {
        {"pad-frequency-stiffening", {"exponent"}, "pad"},
        {"pad-preload-stiffening", {"strength"}, "pad"},
        {"pad-hysteresis", {"loss_factor"}, "pad"},
        {"rail-shear", {"shear_coefficient"}, "rail"},
        {"support-compliance", {"mass_kg", "stiffness_n_per_m", "damping_n_s_per_m"}, "support"},
        {"sleeper-flexibility", {"frequency_hz", "loss_factor", "modal_mass_kg"}, "support"},
        {"rail-damper", {"mass_kg_per_m", "frequency_hz", "loss_factor"}, "rail"},
        {"failed-fasteners", {"every", "fraction", "remaining_stiffness_fraction"}, "pad"},
        {"sleeper-passing", {"amplitude_factor"}, "irregularity"},
        {"wheel-out-of-roundness", {"wheel", "order", "amplitude_m"}, "wheel"},
        {"rail-corrugation", {"wavelength_m", "relative_bandwidth", "rms_m"}, "irregularity"},
        {"rail-joints", {"spacing_m", "depth_m", "length_m"}, "irregularity"},
        {"irregularity-spectrum", {"level_db", "slope_db_per_octave"}, "irregularity"},
        {"body-bending", {"frequency_hz", "damping_ratio", "modal_mass_kg", "shape_at_pivots"}, "body"},
        {"wheelset-bending", {"frequency_hz", "damping_ratio", "modal_mass_kg"}, "wheel"},
        {"bogie-mounted-mass", {"mass_kg", "frequency_hz", "damping_ratio"}, "bogie"},
        {"primary-damper-series-stiffness", {"stiffness_n_per_m"}, "primary"},
        {"secondary-damper-series-stiffness", {"stiffness_n_per_m"}, "secondary"},
        {"suspension-friction", {"stage", "force_n"}, ""},
        {"contact-nonlinearity", {"factor"}, "contact"},
        {"contact-filter", {"patch_half_length_m"}, "contact"},
        {"sensor-gain", {"channel", "gain"}, "sensor"},
        {"sensor-resonance", {"channel", "frequency_hz", "damping_ratio"}, "sensor"},
        {"sensor-noise", {"channel", "rms_m_per_s2", "slope_db_per_octave"}, "sensor"},
        {"timing-skew", {"channel", "delay_s"}, "sensor"},
        {"parameter-error", {"parameter", "factor"}, ""},
    };
    return rows;
}

TEST(EffectLibrary, IsTheCatalogueInItsOrder) {
    ASSERT_EQ(effects().size(), catalogue().size());
    for (std::size_t i = 0; i < effects().size(); ++i) {
        const Effect& effect = effects()[i];
        const Row& row = catalogue()[i];
        EXPECT_EQ(effect.id, row.id);
        EXPECT_EQ(find_effect(row.id), &effect);
        std::set<std::string> names;
        for (const EffectParameter& parameter : effect.parameters)
            if (!parameter.law) names.insert(parameter.name);  // beyond the catalogue
        for (const EffectChoice& choice : effect.choices) names.insert(choice.name);
        EXPECT_EQ(names, std::set<std::string>(row.names.begin(), row.names.end())) << row.id;
        if (*row.element) {
            ASSERT_EQ(effect.elements.size(), 1u) << row.id;
            EXPECT_EQ(element_name(effect.elements.front()), row.element);
        }
    }
    EXPECT_EQ(find_effect("flying-carpet"), nullptr);
}

/// Ranges that the catalogue fixes.
TEST(EffectLibrary, RangesOfTheCatalogue) {
    struct Fixed {
        const char* id;
        const char* name;
        double low, high;
    };
    for (const Fixed& fixed : std::initializer_list<Fixed>{{"pad-frequency-stiffening", "exponent", 0.02, 0.35},
                                                           {"pad-preload-stiffening", "strength", 0.2, 1.5},
                                                           {"pad-hysteresis", "loss_factor", 0.05, 1.0},
                                                           {"rail-shear", "shear_coefficient", 0.34, 0.41},
                                                           {"body-bending", "frequency_hz", 6.0, 16.0},
                                                           {"wheelset-bending", "frequency_hz", 50.0, 110.0},
                                                           {"contact-filter", "patch_half_length_m", 0.003, 0.009}}) {
        bool found = false;
        for (const EffectParameter& parameter : find_effect(fixed.id)->parameters) {
            if (parameter.name != fixed.name) continue;
            found = true;
            EXPECT_EQ(parameter.low, fixed.low) << fixed.id;
            EXPECT_EQ(parameter.high, fixed.high) << fixed.id;
        }
        EXPECT_TRUE(found) << fixed.id;
    }
}

TEST(EffectLibrary, EveryEffectIsDescribedInFull) {
    for (const Effect& effect : effects()) {
        for (const std::string* text : {&effect.says, &effect.equation, &effect.source, &effect.mimics})
            EXPECT_GT(text->size(), 10u) << effect.id;
        EXPECT_FALSE(effect.elements.empty()) << effect.id;
        EXPECT_FALSE(effect.bands.empty()) << effect.id;
        for (const Band& band : effect.bands) EXPECT_LT(band.low_hz, band.high_hz) << effect.id;
        EXPECT_TRUE(effect.apply) << effect.id;
        for (const EffectParameter& p : effect.parameters) {
            EXPECT_LT(p.low, p.high) << effect.id << ' ' << p.name;
            EXPECT_GE(p.typical, p.low) << effect.id << ' ' << p.name;
            EXPECT_LE(p.typical, p.high) << effect.id << ' ' << p.name;
            EXPECT_FALSE(p.unit.empty()) << effect.id << ' ' << p.name;
            EXPECT_FALSE(p.says.empty()) << effect.id << ' ' << p.name;
            if (p.spread == Spread::logarithmic) {
                EXPECT_GT(p.low, 0.0) << effect.id << ' ' << p.name;
            }
        }
        for (const EffectChoice& choice : effect.choices) EXPECT_FALSE(choice.says.empty()) << effect.id;
    }
}

TEST(EffectLibrary, ElementOfAnInstance) {
    const auto element = [](const char* id, const char* choice, const char* value) {
        return element_name(element_of(*find_effect(id), {.effect = id, .choices = {{choice, value}}}));
    };
    EXPECT_EQ(element("suspension-friction", "stage", "primary"), "primary");
    EXPECT_EQ(element("suspension-friction", "stage", "secondary"), "secondary");
    EXPECT_EQ(element("sensor-gain", "channel", "bogie_1"), "sensor");
    struct Key {
        const char *key, *element;
    };
    for (const Key& k : std::initializer_list<Key>{{"vehicle.body_mass_kg", "body"},
                                                   {"vehicle.body_bending[1].frequency_hz", "body"},
                                                   {"vehicle.payload_kg", "body"},
                                                   {"vehicle.bogie_distance_m", "body"},
                                                   {"vehicle.bogie_mass_kg", "bogie"},
                                                   {"vehicle.bogie_mounted_mass[1].mass_kg", "bogie"},
                                                   {"vehicle.wheelbase_m", "bogie"},
                                                   {"vehicle.wheelset_mass_kg", "wheel"},
                                                   {"vehicle.wheel_radius_m", "wheel"},
                                                   {"vehicle.primary.damping_n_s_per_m", "primary"},
                                                   {"vehicle.secondary.stiffness_n_per_m", "secondary"},
                                                   {"track.rail.mass_kg_per_m", "rail"},
                                                   {"track.rail_damper[1].frequency_hz", "rail"},
                                                   {"track.pads.static_stiffness_n_per_m", "pad"},
                                                   {"track.failed_fasteners[1].fraction", "pad"},
                                                   {"track.static.clip_preload_n", "pad"},
                                                   {"track.support.stiffness_n_per_m", "support"},
                                                   {"track.spacing_m", "support"},
                                                   {"contact.constant_m_per_n23", "contact"},
                                                   {"irregularity.band[1].coefficient_m3", "irregularity"},
                                                   {"sleeper_passing.amplitude_factor", "irregularity"},
                                                   {"wheel_out_of_roundness[1].amplitude_m", "wheel"},
                                                   {"sensor[1].gain", "sensor"}})
        EXPECT_EQ(element("parameter-error", "parameter", k.key), k.element) << k.key;
}

TEST(EffectLibrary, StatedOrTypicalValue) {
    const Effect& effect = *find_effect("pad-frequency-stiffening");
    EXPECT_EQ(value_of(effect, {.effect = effect.id}, "exponent"), 0.15);
    EXPECT_EQ(value_of(effect, {.effect = effect.id, .values = {{"exponent", 0.3}}}, "exponent"), 0.3);
}

}  // namespace
}  // namespace railpem::diagnosis

// The simulator hides the same physics that the library names: it keeps a list of its own, because it may not know the
// diagnosis. Every effect of the library exists there with the same parameters, and makes the same case; laws that only
// differ by frequency are those that it marches, the ends of their range (rail dampers have dashpots).

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "app/schema/case_file.hpp"
#include "app/schema/effect_tables.hpp"
#include "simulate/effects/hidden_effects.hpp"
#include "tests/unit/diagnosis/effect_fixtures.hpp"

namespace railpem::diagnosis {
namespace {

/// The instance as the simulator's option reads it.
std::string hide_option(const Effect& effect, const EffectInstance& instance) {
    std::string text = effect.id;
    for (const auto& [name, value] : instance.choices)
        text += fmt::format("{}{}={}", text == effect.id ? ':' : ',', name, value);
    for (const EffectParameter& parameter : effect.parameters)
        if (!parameter.law)
            text += fmt::format("{}{}={}", text == effect.id ? ':' : ',', parameter.name, parameter.typical);
    return text;
}

TEST(SameAsSimulator, EveryEffectMakesTheSameCase) {
    for (const Effect& effect : effects()) {
        pem::CaseParameters believed = believed_case(effect.id);
        believed.track.rail.cross_section_m2 = 7.0e-3;  // stated: the simulator does not derive it from the mass
        EffectInstance instance = typical_instance(effect);
        for (const EffectParameter& parameter : effect.parameters)
            if (parameter.law) instance.values[parameter.name] = parameter.high;
        const ParameterAccess access = app::parameter_access(believed);
        pem::CaseParameters named = believed, hidden = believed;
        apply(instance, access, named);
        simulate::OnlyHereParameters only_here;
        const auto scale = [&](pem::CaseParameters& c, const std::string& key, double factor) {
            access.set(c, key, factor * access.get(c, key));
        };
        simulate::apply_hidden(simulate::parse_hidden(hide_option(effect, instance)), hidden, only_here, scale);
        EXPECT_EQ(app::write_case(named), app::write_case(hidden)) << effect.id;
        EXPECT_NE(app::write_case(named), app::write_case(believed)) << effect.id;
    }
}

/// What can be hidden can be found: the simulator's ranges lie within those of the library. Where an effect is an
/// excess (sleeper passing, contact) less than none is no excess, and on a logarithmic range 0 has no place.
TEST(SameAsSimulator, RangesOfTheLibraryHoldWhatCanBeHidden) {
    for (const Effect& effect : effects())
        for (const simulate::HiddenEffect& hidden : simulate::hidden_effects()) {
            if (hidden.id != effect.id) continue;
            for (const EffectParameter& parameter : effect.parameters)
                for (const simulate::HiddenParameter& other : hidden.parameters) {
                    if (other.name != parameter.name) continue;
                    const bool excess = parameter.strength && parameter.nothing == parameter.low;
                    const bool from_zero = parameter.spread == Spread::logarithmic && other.low == 0.0;
                    if (!excess && !from_zero) {
                        EXPECT_LE(parameter.low, other.low) << effect.id << ' ' << parameter.name;
                    }
                    EXPECT_GE(parameter.high, other.high) << effect.id << ' ' << parameter.name;
                }
        }
}

}  // namespace
}  // namespace railpem::diagnosis

#include <fmt/format.h>

#include <cmath>

#include "diagnosis/effects/catalogue.hpp"
#include "parameters/parameter_error.hpp"

namespace railpem::diagnosis {

Effect parameter_error() {
    return {
        .id = "parameter-error",
        .says = "nothing is missing: a value that was believed is wrong, beyond its tolerance",
        .equation = "value = factor × believed value",
        .source = "the case itself: its values and their tolerances",
        .parameters = {{.name = "factor",
                        .unit = "1",
                        .low = 0.2,
                        .high = 5.0,
                        .typical = 1.4,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 1.0,
                        .says = "true value over believed value"}},
        .choices = {{.name = "parameter", .says = "dotted key of a number of the case"}},
        .elements = {Element::secondary, Element::primary, Element::body, Element::bogie, Element::wheel,
                     Element::contact, Element::rail, Element::pad, Element::support, Element::irregularity,
                     Element::sensor},
        .bands = {{0.3, 200.0}},
        .mimics =
            "Any effect that one wrong value can imitate; what each effect says about its rivals tells the two apart.",
        .obstacle = {},
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess& access) {
                const std::string& key = effect.choices.at("parameter");
                const double believed = access.get(parameters, key);
                if (believed == 0.0 || !std::isfinite(believed))
                    throw parameters::ParameterError(
                        "effect.parameter", fmt::format("'{}' is {:g} and no factor changes that", key, believed),
                        "a number of the case that is neither 0 nor infinite");
                access.set(parameters, key, believed * effect.values.at("factor"));
            },
    };
}

}  // namespace railpem::diagnosis

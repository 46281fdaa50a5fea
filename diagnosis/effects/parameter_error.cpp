#include <fmt/format.h>

#include <cmath>

#include "diagnosis/effects/effect.hpp"
#include "parameters/parameter_error.hpp"

namespace railpem::diagnosis {

EffectInModel parameter_error() {
    return {
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

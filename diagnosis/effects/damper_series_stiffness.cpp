#include "diagnosis/effects/damper_series_stiffness.hpp"

#include <limits>

namespace railpem::diagnosis {

Effect damper_series_stiffness(const DamperSeriesStiffness& stage) {
    return {
        .id = stage.id,
        .says = "the damper of the " + stage.stage +
                " suspension acts through a spring (its bushings, or rubber): fast movements bypass it",
        .equation =
            "Maxwell element: dynamic stiffness k + iωc·k_s/(iωc + k_s); in series with a spring the case has "
            "there already",
        .source = "Bruni, Vinolas, Berg, Polach & Stichel 2011, Vehicle System Dynamics 49",
        .parameters = {{.name = "stiffness_n_per_m",
                        .unit = "N/m",
                        .low = stage.low_n_per_m,
                        .high = stage.high_n_per_m,
                        .typical = stage.typical_n_per_m,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .says = "spring in series with the damper of one element, per rail side"}},
        .elements = {stage.element},
        .bands = {stage.band},
        .mimics = stage.mimics,
        .obstacle = {},
        .apply =
            [suspension = stage.suspension](pem::CaseParameters& parameters, const EffectInstance& effect,
                                            const ParameterAccess&) {
                double& series = (parameters.vehicle.*suspension).damper_series_stiffness_n_per_m;
                series = 1.0 / (1.0 / series + 1.0 / effect.values.at("stiffness_n_per_m"));
            },
    };
}

}  // namespace railpem::diagnosis

#include <limits>

#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect sleeper_flexibility() {
    return {
        .id = "sleeper-flexibility",
        .says = "the sleeper bends under the rail instead of moving as a rigid block",
        .equation =
            "adds to the compliance below each pad 1/(m_n[ω_n²(1 + iη_n) − ω²] + (k(1 + iη) + iωc)·m_n/M), a free "
            "mode of a beam on the same ballast; one instance per mode",
        .source = "Knothe & Grassie 1993, Vehicle System Dynamics 22",
        .parameters = {{.name = "frequency_hz",
                        .unit = "Hz",
                        .low = 60.0,
                        .high = 500.0,
                        .typical = 130.0,
                        .spread = Spread::logarithmic,
                        .says = "frequency of the mode of the free sleeper"},
                       {.name = "loss_factor",
                        .unit = "1",
                        .low = 0.005,
                        .high = 0.3,
                        .typical = 0.03,
                        .spread = Spread::logarithmic,
                        .says = "loss factor of the mode"},
                       {.name = "modal_mass_kg",
                        .unit = "kg",
                        .low = 20.0,
                        .high = 3000.0,
                        .typical = 150.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .says = "modal mass per rail seat for unit displacement there; large when the seat is near a "
                                "node of the mode"}},
        .elements = {Element::support},
        .bands = {{80.0, 250.0}},
        .mimics =
            "A rail damper of the same frequency. The sleeper's mode keeps its frequency with the load and appears "
            "at the sleeper; a hammer test on the sleeper decides.",
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.track.support.model == track::SupportModel::two_layer) return std::nullopt;
            return Obstacle{"there is no sleeper in the case that could bend",
                            "a case with track.support.model = \"two-layer\", or support-compliance beside it"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.track.support.bending_modes.push_back({.frequency_hz = effect.values.at("frequency_hz"),
                                                                  .loss_factor = effect.values.at("loss_factor"),
                                                                  .modal_mass_kg = effect.values.at("modal_mass_kg")});
            },
    };
}

}  // namespace railpem::diagnosis

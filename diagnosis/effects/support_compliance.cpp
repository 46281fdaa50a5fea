#include <limits>

#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect support_compliance() {
    return {
        .id = "support-compliance",
        .says =
            "there is a mass on a spring under the pads: a sleeper on ballast, or a slab on a mat, instead of rigid "
            "ground",
        .equation = "compliance below each pad 1/(k + iωc − ω²M)",
        .source = "Knothe & Grassie 1993, Vehicle System Dynamics 22",
        .parameters = {{.name = "mass_kg",
                        .unit = "kg",
                        .low = 20.0,
                        .high = 2000.0,
                        .typical = 150.0,
                        .spread = Spread::logarithmic,
                        .says = "mass under one rail seat: half a sleeper, or a piece of slab"},
                       {.name = "stiffness_n_per_m",
                        .unit = "N/m",
                        .low = 5e6,
                        .high = 5e8,
                        .typical = 60e6,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .says = "spring under that mass, per rail seat: ballast or mat"},
                       {.name = "damping_n_s_per_m",
                        .unit = "N s/m",
                        .low = 1e3,
                        .high = 5e5,
                        .typical = 5e4,
                        .spread = Spread::logarithmic,
                        .says = "dashpot under that mass, per rail seat"}},
        .elements = {Element::support},
        .bands = {{20.0, 200.0}},
        .mimics =
            "Softer pads (parameter-error of the pad) below the frequency of mass and spring; above it the mass "
            "stands still and the track is as stiff as believed, which softer pads never are. sleeper-flexibility "
            "and rail-damper also make a dip and a peak; a receptance at the sleeper, or more than one speed, "
            "separates.",
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.track.support.model == track::SupportModel::rigid) return std::nullopt;
            return Obstacle{"the case has a mass and a spring under the pads already",
                            "a case with track.support.model = \"rigid\"; other values of them are a parameter-error"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                track::SupportParameters& support = parameters.track.support;
                support.model = track::SupportModel::two_layer;
                support.mass_kg = effect.values.at("mass_kg");
                support.stiffness_n_per_m = effect.values.at("stiffness_n_per_m");
                support.damping_n_s_per_m = effect.values.at("damping_n_s_per_m");
                support.loss_factor = 0.0;
            },
    };
}

}  // namespace railpem::diagnosis

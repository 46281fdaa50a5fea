#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kSteelDensity = 7850.0;  // kg/m³

}  // namespace

EffectInModel rail_shear() {
    return {
        // from one support to the next its receptance swings four times as far as an Euler rail's: the mean is 0.2 %
        // off at 150 Hz, and what swings is taken to first order
        .approximate = true,
        .replaces = true,
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.track.rail.beam == track::Beam::euler) return std::nullopt;
            return Obstacle{"the rail of the case shears already",
                            "a case with track.rail.beam = \"euler\"; another shear coefficient is a parameter-error"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                track::RailParameters& rail = parameters.track.rail;
                rail.beam = track::Beam::timoshenko;
                rail.shear_coefficient = effect.values.at("shear_coefficient");
                // An Euler rail need not state its cross-section: the default is of another rail.
                if (rail.cross_section_m2 == track::RailParameters{}.cross_section_m2)
                    rail.cross_section_m2 = rail.mass_kg_per_m / kSteelDensity;
            },
    };
}

}  // namespace railpem::diagnosis

#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kSteelDensity = 7850.0;  // kg/m³

}  // namespace

Effect rail_shear() {
    return {
        .id = "rail-shear",
        .says =
            "the rail shears, and its section has inertia when it rotates: it is softer between the pads than a beam "
            "that only bends",
        .equation =
            "Timoshenko beam: EI ψ'' + κGA(w' − ψ) = −ρIω²ψ, κGA(w'' − ψ') = −mω²w + load; A = m/(7850 kg/m³) "
            "unless the case states a cross-section",
        .source = "Timoshenko 1921, Phil. Mag. 41; Grassie, Gregory, Harrison & Johnson 1982, J. Mech. Eng. Sci. 24",
        .parameters = {{.name = "shear_coefficient",
                        .unit = "1",
                        .low = 0.34,
                        .high = 0.41,
                        .typical = 0.38,
                        .inexact = 0.02,  // scripts/interval_misses.py
                        .says = "share κ of the cross-section that carries shear"}},
        .elements = {Element::rail},
        .bands = {{30.0, 500.0}},
        .mimics =
            "A rail with less bending stiffness (parameter-error of track.rail.second_moment_of_area_m4) is as soft "
            "at one frequency; a receptance at mid-bay and over a pad, or the pinned–pinned frequency, separates. "
            "In a running train it shows mostly as a larger sleeper-passing line.",
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

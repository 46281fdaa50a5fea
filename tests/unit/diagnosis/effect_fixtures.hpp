#pragma once
// Cases and instances to try effects on.

#include "diagnosis/effects/effect.hpp"
#include "parameters/parameter_error.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::diagnosis {

/// Numbers of a case that the tests reach by key; the application hands over all of them.
inline ParameterAccess some_numbers() {
    const auto number = [](pem::CaseParameters& c, const std::string& key) -> double& {
        if (key == "vehicle.bogie_mass_kg") return c.vehicle.bogie_mass_kg;
        if (key == "contact.patch_half_length_m") return c.contact.patch_half_length_m;
        return c.track.pads.static_stiffness_n_per_m;
    };
    return {.get = [number](const pem::CaseParameters& c,
                            const std::string& key) { return number(const_cast<pem::CaseParameters&>(c), key); },
            .set = [number](pem::CaseParameters& c, const std::string& key, double value) { number(c, key) = value; },
            .keys = {"vehicle.bogie_mass_kg", "contact.patch_half_length_m", "track.pads.static_stiffness_n_per_m"}};
}

/// The effect with the choices it needs and nothing else: everything typical.
inline EffectInstance typical_instance(const Effect& effect) {
    EffectInstance instance{.effect = effect.id};
    for (const EffectChoice& choice : effect.choices) {
        if (!choice.required) continue;
        instance.choices[choice.name] = choice.options.empty() ? "vehicle.bogie_mass_kg" : choice.options.front();
    }
    return instance;
}

/// Case 1 of Wei et al. 2016 on a coarse grid, with what an effect needs before it can be added: a sleeper to bend, and
/// the sleeper passing and Hertz contact over which an excess is an excess.
inline pem::CaseParameters believed_case(const std::string& effect) {
    pem::CaseParameters c = tests::paper_case(1);
    c.frequency = {.from_hz = 1.0, .to_hz = 181.0, .step_hz = 2.5};
    if (effect == "sleeper-passing") c.sleeper_passing.amplitude_factor = 1.0;
    if (effect == "contact-nonlinearity") c.contact.nonlinearity_factor = 1.0;
    if (effect == "sleeper-flexibility")
        c.track.support = {.model = track::SupportModel::two_layer,
                           .mass_kg = 150.0,
                           .stiffness_n_per_m = 60e6,
                           .damping_n_s_per_m = 5e4};
    return c;
}

}  // namespace railpem::diagnosis

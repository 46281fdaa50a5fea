#pragma once
// Believed cases with few uncertain numbers and recordings drawn from them: what the engine's tests share.

#include <map>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/synthesis.hpp"
#include "parameters/parameter_error.hpp"
#include "pem/contact.hpp"
#include "tests/unit/diagnosis/nature_of.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::diagnosis {

/// Numbers of a case by key, for the tests.
inline double& number_at(pem::CaseParameters& c, const std::string& key) {
    const std::map<std::string, double*> numbers = {
        {"vehicle.body_mass_kg", &c.vehicle.body_mass_kg},
        {"vehicle.body_pitch_inertia_kg_m2", &c.vehicle.body_pitch_inertia_kg_m2},
        {"vehicle.bogie_pitch_inertia_kg_m2", &c.vehicle.bogie_pitch_inertia_kg_m2},
        {"track.rail.second_moment_of_area_m4", &c.track.rail.second_moment_of_area_m4},
        {"track.rail.mass_kg_per_m", &c.track.rail.mass_kg_per_m},
        {"vehicle.bogie_mass_kg", &c.vehicle.bogie_mass_kg},
        {"vehicle.wheelset_mass_kg", &c.vehicle.wheelset_mass_kg},
        {"vehicle.primary.stiffness_n_per_m", &c.vehicle.primary.stiffness_n_per_m},
        {"vehicle.primary.damping_n_s_per_m", &c.vehicle.primary.damping_n_s_per_m},
        {"vehicle.secondary.stiffness_n_per_m", &c.vehicle.secondary.stiffness_n_per_m},
        {"vehicle.secondary.damping_n_s_per_m", &c.vehicle.secondary.damping_n_s_per_m},
        {"contact.constant_m_per_n23", &c.contact.constant_m_per_n23},
        {"track.pads.static_stiffness_n_per_m", &c.track.pads.static_stiffness_n_per_m},
        {"track.pads.damping_n_s_per_m", &c.track.pads.damping_n_s_per_m},
    };
    const auto found = numbers.find(key);
    if (found == numbers.end()) throw parameters::ParameterError(key, "is no number of this test", "another key");
    return *found->second;
}

/// Tolerances as a case file has them by default.
inline double tolerance_of(const std::string& key) {
    if (key.starts_with("track.rail")) return 0.02;
    if (key.find("mass") != std::string::npos || key.find("inertia") != std::string::npos) return 0.05;
    if (key.starts_with("track.pads")) return 0.3;
    return key.find("damping") != std::string::npos || key.starts_with("contact") ? 0.15 : 0.1;
}

/// Case 1 of Wei et al. 2016 with these numbers uncertain.
inline BelievedCase paper_believed(const std::vector<std::string>& uncertain) {
    BelievedCase believed{.numbers = tests::paper_case(1)};
    pem::CaseParameters& numbers = believed.numbers;
    if (numbers.contact.constant_m_per_n23 == 0.0)
        numbers.contact.constant_m_per_n23 = pem::contact_constant(numbers.contact, numbers.vehicle.wheel_radius_m);
    believed.access = {
        .get = [](const pem::CaseParameters& c,
                  const std::string& key) { return number_at(const_cast<pem::CaseParameters&>(c), key); },
        .set = [](pem::CaseParameters& c, const std::string& key, double value) { number_at(c, key) = value; },
        .keys = uncertain};
    for (const std::string& key : uncertain)
        believed.uncertain.push_back({.key = key,
                                      .value = number_at(numbers, key),
                                      .tolerance = tolerance_of(key),
                                      .element = element_of_key(key),
                                      .range = {},
                                      .unit = {},
                                      .nature = nature_of(key)});
    return believed;
}

/// All that a train carries: nine channels.
inline std::vector<std::string> nine_channels() {
    return {"body_front", "body", "body_rear", "bogie_1", "bogie_2", "wheel_1", "wheel_2", "wheel_3", "wheel_4"};
}

/// A believed case, recordings drawn from a truth, and the question about them.
struct Synthesised {
    BelievedCase believed;
    std::vector<Observation> shapes, observations;
    Trial truth;

    LikelihoodContext context(Part part = Part::fitted, int threads = 1) const {
        return {
            .believed = &believed, .observations = &observations, .part = part, .least_floor = 0.0, .threads = threads};
    }
    void draw(std::uint64_t seed) {
        observations.clear();
        for (std::size_t o = 0; o < shapes.size(); ++o)
            observations.push_back(synthesise(shapes[o], o, truth, believed, seed));
    }
};

/// Few bins, for tests that need no more.
inline constexpr ObservationOptions kSmall{.window_s = 1.0, .low_hz = 4.0, .high_hz = 40.0};
/// Lines close enough to tell apart those of a comb of dips.
inline constexpr ObservationOptions kFine{.window_s = 4.0, .low_hz = 4.0, .high_hz = 80.0};

/// Recordings at several speeds, not drawn yet; the truth is the believed case.
inline Synthesised synthesised(BelievedCase believed, const std::vector<double>& speeds, double seconds,
                               const std::vector<std::string>& responses, const ObservationOptions& options) {
    Synthesised made{.believed = std::move(believed)};
    for (const double speed : speeds) {
        made.shapes.push_back(observation_shape(speed, 0.0, seconds, responses, made.believed.numbers, options));
        made.shapes.back().name = "at " + std::to_string(speed);
    }
    made.truth = believed_trial(made.believed, made.shapes);
    return made;
}

/// The fit of these effects beside everything that is retuned, from the instances' own values.
inline Fit fitted_with(const Synthesised& made, const std::vector<EffectInstance>& instances) {
    Trial trial = believed_trial(made.believed, made.observations);
    std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    std::vector<double> start = means(unknowns);
    for (const EffectInstance& instance : instances) {
        for (const Unknown& unknown : effect_unknowns(instance, static_cast<int>(trial.effects.size()))) {
            const EffectParameter& parameter = *parameter_of(unknown);
            unknowns.push_back(unknown);
            start.push_back(
                to_coordinate(parameter, value_of(*find_effect(instance.effect), instance, parameter.name)));
        }
        trial.effects.push_back(instance);
    }
    return fit(trial, unknowns, start, made.context());
}

/// The same of one.
inline Fit fitted_with(const Synthesised& made, const EffectInstance& instance) {
    return fitted_with(made, std::vector<EffectInstance>{instance});
}

}  // namespace railpem::diagnosis

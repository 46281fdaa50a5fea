#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel failed_fasteners() {
    return {
        .abrupt = true,
        // what swings between a failed seat and the next is as if the wheels stood everywhere; of seats at random to
        // first order
        .approximate = true,
        // rails 0.8 times as heavy, contacts twice as soft: 4.8 to 10.8 tolerances beside five right ones before what
        // regular ones scatter was expected, 12.9 and more beside plays of the fastenings
        .bends_numbers = 11.0,
        .needs_train = true,
        .needs_lines = true,
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.track.failed_fasteners.empty()) return std::nullopt;
            return Obstacle{"the case has failed fasteners already", "a case without [[track.failed_fasteners]]"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                const auto every = effect.choices.find("every");
                track::FailedFasteners failed;
                failed.remaining_stiffness_fraction = effect.values.at("remaining_stiffness_fraction");
                if (every != effect.choices.end())
                    failed.every = std::stoi(every->second);
                else
                    failed.fraction = effect.values.at("fraction");
                parameters.track.failed_fasteners.push_back(failed);
            },
    };
}

}  // namespace railpem::diagnosis

#include "diagnosis/model/reuse.hpp"

#include <algorithm>

#include "diagnosis/model/loaded_pads.hpp"
#include "diagnosis/observations/shows.hpp"

namespace railpem::diagnosis {

namespace {

/// Linearised laws depend on the excitation.
bool depends_on_level(const Trial& trial) {
    return trial.numbers.vehicle.primary.friction_force_n > 0.0 ||
           trial.numbers.vehicle.secondary.friction_force_n > 0.0 || trial.numbers.contact.nonlinearity_factor > 0.0 ||
           std::any_of(trial.effects.begin(), trial.effects.end(),
                       [](const EffectInstance& effect) { return find_effect(effect.effect)->follows_level; });
}

Reuse shared_with_element(const Trial& trial, Element element) {
    switch (element) {
        case Element::irregularity:
            return depends_on_level(trial) ? Reuse::rail : Reuse::transfers;
        case Element::sensor:
            return Reuse::motion;
        case Element::pad:
        case Element::rail:
        case Element::support:
            return Reuse::nothing;
        case Element::contact:
        case Element::primary:
        case Element::secondary:
            return Reuse::rail;
        case Element::body:
        case Element::bogie:
        case Element::wheel:
            break;
    }
    // The wheel load moves the pads where their stiffness follows it.
    const bool load_matters = trial.numbers.track.statics.wheel_load_n == 0.0 && load_stiffens_pads(trial);
    return load_matters ? Reuse::nothing : Reuse::rail;
}

Reuse shared_with_lines(const Trial& trial) {
    return depends_on_level(trial) ? Reuse::rail : Reuse::broadband;
}

}  // namespace

Reuse shared_with(const Trial& trial, const Unknown& unknown) {
    switch (unknown.kind) {
        case UnknownKind::irregularity:
            return shared_with_element(trial, Element::irregularity);
        case UnknownKind::passing:
        case UnknownKind::width:
            return shared_with_lines(trial);
        case UnknownKind::number:
            return shared_with_element(trial, element_of_key(unknown.name));
        case UnknownKind::effect:
            return shared_with(trial, trial.effects[static_cast<std::size_t>(unknown.index)]);
        case UnknownKind::correction:
            return shared_with_element(trial, unknown.element);
        case UnknownKind::gain:
        case UnknownKind::calibration:
        case UnknownKind::met_alone:
            return Reuse::transfers;
        default:
            return Reuse::nothing;
    }
}

Reuse shared_with(const Trial& trial, const EffectInstance& effect) {
    const Effect& own = *find_effect(effect.effect);
    if (own.lines_alone) return shared_with_lines(trial);
    return shared_with_element(trial, own.excites ? Element::irregularity : element_of(own, effect));
}

Reuse shared_with_probe(const Trial& trial, const EffectInstance& probe) {
    const Effect& own = *find_effect(probe.effect);
    if (own.retuned) return shared_with(trial, probe);
    if (own.lines_alone) return Reuse::broadband;
    return own.excites || element_of(own, probe) == Element::irregularity ? Reuse::transfers
                                                                          : shared_with(trial, probe);
}

bool moves(const Unknown& unknown, const Trial& trial, const Observation& observation, std::size_t o) {
    if (unknown.observation >= 0 && unknown.observation != static_cast<int>(o)) return false;
    switch (unknown.kind) {
        case UnknownKind::noise:
        case UnknownKind::flicker:
        case UnknownKind::floor:
        case UnknownKind::discrepancy:
            return false;
        case UnknownKind::number:
            return reaches(observation, element_of_key(unknown.name));
        case UnknownKind::correction:
            return reaches(observation, unknown.element);
        case UnknownKind::irregularity:
        case UnknownKind::passing:
        case UnknownKind::width:
            return reaches(observation, Element::irregularity);
        case UnknownKind::met_alone:
            return !observation.scalar && reaches(observation, Element::irregularity);
        case UnknownKind::effect: {
            const EffectInstance& instance = trial.effects[static_cast<std::size_t>(unknown.index)];
            return could_show(observation, *find_effect(instance.effect));
        }
        default:
            return true;
    }
}

}  // namespace railpem::diagnosis

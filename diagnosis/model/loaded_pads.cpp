#include "diagnosis/model/loaded_pads.hpp"

#include <algorithm>

namespace railpem::diagnosis {

bool load_stiffens_pads(const Trial& trial) {
    return trial.numbers.track.pads.preload_strength > 0.0 ||
           std::any_of(trial.effects.begin(), trial.effects.end(),
                       [](const EffectInstance& effect) { return find_effect(effect.effect)->follows_load; });
}

}  // namespace railpem::diagnosis

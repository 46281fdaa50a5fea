#include <algorithm>

#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

const std::vector<Effect>& effects() {
    static const std::vector<Effect> library = {
        pad_frequency_stiffening(),
        pad_preload_stiffening(),
        pad_hysteresis(),
        rail_shear(),
        support_compliance(),
        sleeper_flexibility(),
        rail_damper(),
        failed_fasteners(),
        sleeper_passing(),
        wheel_out_of_roundness(),
        rail_corrugation(),
        rail_joints(),
        irregularity_spectrum(),
        body_bending(),
        wheelset_bending(),
        bogie_mounted_mass(),
        primary_damper_series_stiffness(),
        secondary_damper_series_stiffness(),
        suspension_friction(),
        contact_nonlinearity(),
        contact_filter(),
        sensor_gain(),
        sensor_resonance(),
        sensor_noise(),
        timing_skew(),
        parameter_error(),
    };
    return library;
}

const Effect* find_effect(const std::string& id) {
    const auto found =
        std::find_if(effects().begin(), effects().end(), [&](const Effect& effect) { return effect.id == id; });
    return found == effects().end() ? nullptr : &*found;
}

}  // namespace railpem::diagnosis

#include "diagnosis/effects/damper_series_stiffness.hpp"

namespace railpem::diagnosis {

EffectInModel secondary_damper_series_stiffness() {
    return damper_series_stiffness(&vehicle::VehicleParameters::secondary);
}

}  // namespace railpem::diagnosis

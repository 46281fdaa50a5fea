#include "diagnosis/effects/damper_series_stiffness.hpp"

namespace railpem::diagnosis {

EffectInModel primary_damper_series_stiffness() {
    return damper_series_stiffness(&vehicle::VehicleParameters::primary);
}

}  // namespace railpem::diagnosis

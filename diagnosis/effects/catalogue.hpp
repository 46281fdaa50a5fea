#pragma once
// The effects of the catalogue, each in the file of its name.

#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

Effect pad_frequency_stiffening();
Effect pad_preload_stiffening();
Effect pad_hysteresis();
Effect rail_shear();
Effect support_compliance();
Effect sleeper_flexibility();
Effect rail_damper();
Effect failed_fasteners();
Effect sleeper_passing();
Effect wheel_out_of_roundness();
Effect rail_corrugation();
Effect rail_joints();
Effect irregularity_spectrum();
Effect body_bending();
Effect wheelset_bending();
Effect bogie_mounted_mass();
Effect primary_damper_series_stiffness();
Effect secondary_damper_series_stiffness();
Effect suspension_friction();
Effect contact_nonlinearity();
Effect contact_filter();
Effect sensor_gain();
Effect sensor_resonance();
Effect sensor_noise();
Effect timing_skew();
Effect parameter_error();

}  // namespace railpem::diagnosis

#pragma once
// Case 3 with every effect of rail, pads and support.

#include "paper_case.hpp"

namespace railpem::tests {

inline pem::CaseParameters every_track_effect() {
    pem::CaseParameters c = paper_case(3);
    c.track.pads.causal = true;
    c.track.pads.loss_factor = 0.2;
    c.track.rail.beam = track::Beam::timoshenko;
    c.track.rail.cross_section_m2 = 60.64 / 7850.0;
    c.track.support = {.model = track::SupportModel::two_layer,
                       .mass_kg = 150.0,
                       .stiffness_n_per_m = 60e6,
                       .loss_factor = 0.5,
                       .bending_modes = {{.frequency_hz = 120.0, .loss_factor = 0.02, .modal_mass_kg = 80.0}}};
    c.track.rail_dampers = {{.mass_kg_per_m = 15.0, .frequency_hz = 120.0, .loss_factor = 0.3}};
    c.track.failed_fasteners = {{.every = 8}};
    c.sleeper_passing.amplitude_factor = 1.0;
    return c;
}

}  // namespace railpem::tests

#pragma once
// What the forces of passing sleepers do between the sleepers.

#include <vector>

#include "pem/coupling/coupled_model.hpp"
#include "pem/coupling/excitation.hpp"

namespace railpem::pem {

/// Adds to the second and higher lines of `passing` (passing_lines() of sound fasteners) what the force of the first
/// one makes of them: it swells and fades once a bay, as the rail under it does, so that the rail gives way twice a
/// bay. Without it the second line is up to 4 % too large (Moving.SecondSleeperPassingLine). The forces of higher
/// lines, and what comes back to the first, are of the next order and left out. `model` is linearised.
void feed_back(const CaseParameters& parameters, const CoupledModel& model, double speed_m_per_s,
               std::vector<SpectralLine>& passing);

}  // namespace railpem::pem

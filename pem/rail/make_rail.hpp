#pragma once
// The rail of a case.

#include <memory>
#include <vector>

#include "pem/case_parameters.hpp"
#include "pem/rail/rail_model.hpp"
#include "track/statics/static_equilibrium.hpp"

namespace railpem::pem {

/// The rail that the case asks for (solver.rail), on the pads of the static equilibrium; with solver.moving under
/// wheels that roll (rolling_rail.hpp), the exact one on the pads as they press them.
std::unique_ptr<RailModel> make_rail(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                     const track::StaticEquilibrium& equilibrium, double speed_m_per_s = 0.0);

}  // namespace railpem::pem

#pragma once
// The rail under wheels in motion.

#include <memory>
#include <vector>

#include "pem/case_parameters.hpp"
#include "pem/rail/rail_model.hpp"

namespace railpem::pem {

/// Wheels that roll over the case's track at `speed_m_per_s` > 0: order 0 of track::rolling_receptance() on equal
/// seats, and the difference that other seats make to wheels at rest, in the mean over their positions (pads that load
/// stiffens as rolling wheels press them, track/statics/moving_equilibrium.hpp; numbered failed fasteners; random ones
/// enter by their mean).
std::unique_ptr<RailModel> rolling_rail(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                        double speed_m_per_s);

/// The same with `standing` in the place of those seats: a rail at rest, its wheels where the case has them.
std::unique_ptr<RailModel> rolling_rail(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                        double speed_m_per_s, std::unique_ptr<RailModel> standing);

}  // namespace railpem::pem

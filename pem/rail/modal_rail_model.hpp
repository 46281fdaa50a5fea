#pragma once
// The finite rail by its bending modes.

#include <memory>
#include <vector>

#include "pem/rail/rail_model.hpp"
#include "track/statics/static_equilibrium.hpp"
#include "track/track_parameters.hpp"

namespace railpem::pem {

/// A simply supported rail with its first `modes`, on the pads of `equilibrium`; the wheels at `points_m`.
std::unique_ptr<RailModel> modal_rail_model(const track::TrackParameters& track, const std::vector<double>& points_m,
                                            int modes, const track::StaticEquilibrium& equilibrium);

}  // namespace railpem::pem

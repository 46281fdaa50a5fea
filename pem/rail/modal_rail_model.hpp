#pragma once
// The finite rail by its bending modes.

#include <memory>
#include <vector>

#include "pem/case_parameters.hpp"
#include "pem/rail/rail_model.hpp"
#include "track/statics/static_equilibrium.hpp"

namespace railpem::pem {

/// A simply supported rail with the modes that the case asks for, on the pads of `equilibrium`.
std::unique_ptr<RailModel> modal_rail_model(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                            const track::StaticEquilibrium& equilibrium);

}  // namespace railpem::pem

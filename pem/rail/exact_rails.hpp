#pragma once
// The infinite rail, at one position of the wheels or in the mean over several.

#include <memory>
#include <vector>

#include "pem/rail/rail_model.hpp"
#include "track/rail/exact_rail.hpp"

namespace railpem::pem {

/// The mean over rails that the wheels meet alike often.
std::unique_ptr<RailModel> exact_rails(std::vector<track::ExactRail> rails);

}  // namespace railpem::pem

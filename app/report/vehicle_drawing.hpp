#pragma once

#include <string>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app::report {

/// Vehicle and track from the side as SVG, every element of the structure labelled, the places coloured by their
/// probability. The front is at the right. Not to scale.
std::string vehicle_drawing(const diagnosis::Diagnosis& diagnosis);

}  // namespace railpem::app::report

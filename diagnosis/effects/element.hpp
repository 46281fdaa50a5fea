#pragma once

#include <string>

#include "effects/element.hpp"

namespace railpem::diagnosis {

using effects::Element;
using effects::element_name;

/// The element to which a number of the case belongs, by its dotted key: "track.pads.exponent" is of the pad.
Element element_of_key(const std::string& key);

}  // namespace railpem::diagnosis

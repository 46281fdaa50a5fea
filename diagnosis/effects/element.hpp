#pragma once

#include <string>

namespace railpem::diagnosis {

/// Elements of the structure in which an effect can sit.
enum class Element { secondary, primary, body, bogie, wheel, contact, rail, pad, support, irregularity, sensor };

/// The element as the diagnosis writes it.
std::string element_name(Element element);

/// The element to which a number of the case belongs, by its dotted key: "track.pads.exponent" is of the pad.
Element element_of_key(const std::string& key);

}  // namespace railpem::diagnosis

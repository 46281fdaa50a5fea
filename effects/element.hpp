#pragma once

#include <string>

namespace railpem::effects {

/// Elements of the structure in which an effect can sit.
enum class Element { secondary, primary, body, bogie, wheel, contact, rail, pad, support, irregularity, sensor };

/// The element as cases, truths and diagnoses write it.
std::string element_name(Element element);

}  // namespace railpem::effects

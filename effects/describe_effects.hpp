#pragma once

#include <string>

namespace railpem::effects {

/// The reference page of the effects that a diagnosis knows, Markdown.
std::string describe_effects();

}  // namespace railpem::effects

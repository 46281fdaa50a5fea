#pragma once

#include "ranks/crew.hpp"

namespace railpem::ranks {

/// One process, no messages.
std::unique_ptr<Crew> alone();

}  // namespace railpem::ranks

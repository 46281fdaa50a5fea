#pragma once
// The crew of an MPI job; only in a build with MPI.

#include <memory>

#include "ranks/crew.hpp"

namespace railpem::ranks {

/// All processes that the launcher has started. Once per process.
std::unique_ptr<Crew> mpi_crew();

}  // namespace railpem::ranks

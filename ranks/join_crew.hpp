#pragma once

#include <memory>

#include "ranks/crew.hpp"

namespace railpem::ranks {

/// Joins the processes that an MPI launcher (mpirun, srun) has started together. Alone without a launcher, or in a
/// build without MPI. Once per process.
std::unique_ptr<Crew> join_crew();

}  // namespace railpem::ranks

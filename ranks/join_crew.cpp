#include "ranks/join_crew.hpp"

#include <cstdlib>

#include "ranks/alone.hpp"
#include "ranks/mpi_crew.hpp"

namespace railpem::ranks {

#ifdef RAILPEM_MPI

namespace {

/// A launcher leaves word in the environment: PMIx (Open MPI, Slurm) or PMI (MPICH, Slurm). Without one MPI would have
/// to start a server for a single process.
bool launched() {
    return std::getenv("PMIX_RANK") || std::getenv("PMI_RANK") || std::getenv("OMPI_COMM_WORLD_RANK");
}

}  // namespace

std::unique_ptr<Crew> join_crew() {
    if (!launched()) return alone();
    return mpi_crew();
}

#else

std::unique_ptr<Crew> join_crew() {
    return alone();
}

#endif

}  // namespace railpem::ranks

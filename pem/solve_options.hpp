#pragma once
// How a solution is asked for, and how it ends early.

#include <cstddef>
#include <functional>

namespace railpem::pem {

/// Thrown instead of a result that somebody no longer wants.
struct Interrupted {};

struct SolveOptions {
    int threads = 0;  ///< 0: as many as OpenMP offers
    /// Called now and then from one thread with lines done and lines in all.
    std::function<void(std::size_t, std::size_t)> progress;
    /// Asked between lines, from several threads at a time; true ends the solution with Interrupted.
    std::function<bool()> interrupted;
};

}  // namespace railpem::pem

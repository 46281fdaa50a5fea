#pragma once
// Threads of OpenMP, or the one there is without it.

#ifdef _OPENMP
#include <omp.h>
#endif

#include <atomic>
#include <exception>

namespace railpem::pem {

/// How many threads a request means: itself, or as many as the machine offers when it is 0. Without OpenMP 1.
inline int thread_count([[maybe_unused]] int requested) {
#ifdef _OPENMP
    return requested > 0 ? requested : omp_get_max_threads();
#else
    return 1;
#endif
}

/// Number of the calling thread within its team; 0 is the one that began it.
inline int thread_number() {
#ifdef _OPENMP
    return omp_get_thread_num();
#else
    return 0;
#endif
}

/// Carries the first exception of a team of threads past the end of its parallel region, which none may leave by
/// throwing.
class TeamFailure {
  public:
    /// Runs `work`, or nothing after something has failed in any thread.
    template <class Work>
    void guard(const Work& work) {
        if (failed_) return;
        try {
            work();
        } catch (...) {
            if (!failed_.exchange(true)) first_ = std::current_exception();
        }
    }
    /// After the region: throws what failed.
    void rethrow() const {
        if (first_) std::rethrow_exception(first_);
    }

  private:
    std::atomic<bool> failed_{false};
    std::exception_ptr first_;
};

}  // namespace railpem::pem

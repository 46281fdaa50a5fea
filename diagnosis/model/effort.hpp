#pragma once
// How much a search has computed, counted rather than timed: a search that is ended by it ends the same on every
// machine and with any number of threads.

#include <atomic>
#include <cstddef>
#include <cstdint>

#include <string>

#include "diagnosis/model/not_tested.hpp"
#include "diagnosis/model/trial.hpp"

namespace railpem::diagnosis {

/// A count of work in seconds that it takes one core of the EPYC of docs/speed.md, right to some ten per cent: what a
/// prediction takes there, by what it reuses and what is in it, and what a likelihood takes. Safe between threads.
class Effort {
  public:
    void add(double seconds) {
        nanoseconds_.fetch_add(static_cast<std::int64_t>(1e9 * seconds), std::memory_order_relaxed);
    }
    double seconds() const { return 1e-9 * static_cast<double>(nanoseconds_.load(std::memory_order_relaxed)); }

  private:
    std::atomic<std::int64_t> nanoseconds_{0};  ///< whole numbers: their sum does not depend on the order
};

/// One prediction of a recording of `bins` bins for a case with all effects applied, s; `sharp`:
/// ExpectationOptions::sharp.
double effort_of_prediction(const pem::CaseParameters& parameters, std::size_t bins, Reuse reuse, bool sharp = true);

/// One likelihood of `bins` bins, with its slope in `unknowns` (0: without), s.
double effort_of_likelihood(std::size_t bins, std::size_t unknowns);

/// What a search may take at most, s: `for_three` where three recordings of a minute with nine channels are diagnosed,
/// or fewer; more in proportion to their bands where there are more.
double effort_allowed(const std::vector<Observation>& observations, double for_three);

/// What was left out because so much was spent.
NotTested left_out_for_effort(const std::string& what, const Effort& spent, double allowed_s);

}  // namespace railpem::diagnosis

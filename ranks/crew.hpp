#pragma once
// Several processes that work on one job, or one process alone.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

namespace railpem::ranks {

/// Hands out the numbers 0 … count − 1, each once over all processes, lower ones first. From any thread.
class Dispenser {
  public:
    virtual ~Dispenser() = default;
    /// The next number, nothing when all are given away.
    virtual std::optional<std::size_t> next() = 0;
    /// Process 0: how many have been given away, to all processes. Others: to this one.
    virtual std::size_t given() const = 0;
};

/// The processes of a job. Every member function must be called by all of them, in the same order, from the thread that
/// made it.
class Crew {
  public:
    virtual ~Crew() = default;
    virtual int rank() const = 0;  ///< 0 … size() − 1; 0 writes the result
    virtual int size() const = 0;
    /// Waits until every process is here.
    virtual void meet() = 0;
    /// A dispenser for `count` numbers. All must take until it is empty or be destroyed before it is.
    virtual std::unique_ptr<Dispenser> dispense(std::size_t count) = 0;

    /// Runs `work` in process 0 first, then in all others: what is refused is said once, what is made is made once.
    void first_then_others(const std::function<void()>& work);
};

/// How many numbers to hand over at a time when so many are left: many at first, so that messages are few, single ones
/// at the end, so that all end together.
std::size_t share_of(std::size_t left, int processes);

}  // namespace railpem::ranks

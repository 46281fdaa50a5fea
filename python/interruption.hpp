#pragma once
// Ctrl-C while the program computes and the interpreter sleeps.

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <thread>

namespace railpem::python {

/// Asks the interpreter now and then whether a signal has arrived. It belongs to the thread that made it; others learn
/// what that one found. Signals reach the main thread of Python only, so a computation in another thread runs to its
/// end.
class Interruption {
  public:
    /// Whether the computation shall end. From any thread, without the interpreter's lock; cheap.
    bool asked();
    /// Throws pem::Interrupted when it shall.
    void check();
    /// Throws what the signal raised in Python, KeyboardInterrupt as a rule. With the interpreter's lock.
    [[noreturn]] void raise();

  private:
    using Clock = std::chrono::steady_clock;
    std::thread::id thread_ = std::this_thread::get_id();
    Clock::time_point last_ = Clock::now();
    std::atomic<bool> asked_{false};
    std::exception_ptr raised_;
};

/// Runs `work(interruption)` without the interpreter's lock and gives what it returns. A signal ends it with what the
/// signal raises, whether the work stopped half-way or returned what it knew.
template <class Work>
auto interruptible(const Work& work) {
    Interruption interruption;
    try {
        const pybind11::gil_scoped_release released;
        auto result = work(interruption);
        if (!interruption.asked()) return result;
    } catch (...) {
        if (!interruption.asked()) throw;
    }
    interruption.raise();
}

}  // namespace railpem::python

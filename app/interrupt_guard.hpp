#pragma once

#include <csignal>

namespace railpem::app {

/// While it lives, Ctrl-C asks for an end with what is known; a second one ends the program at once. One at a time.
class InterruptGuard {
  public:
    static constexpr int kInterrupted = 130;  ///< exit status of a program that Ctrl-C ended

    InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    ~InterruptGuard();

    /// Whether an end was asked for since the guard was made.
    static bool asked();

  private:
    void (*previous_)(int) = SIG_DFL;
};

}  // namespace railpem::app

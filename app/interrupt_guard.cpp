#include "app/interrupt_guard.hpp"

#include <atomic>
#include <cstdlib>

namespace railpem::app {

namespace {

// A signal has no other way to leave word.
std::atomic<bool> interrupt_asked{false};

void on_interrupt(int) {
    if (interrupt_asked.exchange(true)) std::_Exit(InterruptGuard::kInterrupted);
}

}  // namespace

InterruptGuard::InterruptGuard() {
    interrupt_asked = false;
    previous_ = std::signal(SIGINT, on_interrupt);
}

InterruptGuard::~InterruptGuard() {
    std::signal(SIGINT, previous_);
}

bool InterruptGuard::asked() {
    return interrupt_asked.load();
}

}  // namespace railpem::app

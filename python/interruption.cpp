#include "python/interruption.hpp"

#include "pem/solve_options.hpp"

namespace railpem::python {

namespace {

constexpr std::chrono::milliseconds kBetween{20};  ///< below what a user notices, above what it costs

}  // namespace

bool Interruption::asked() {
    if (asked_) return true;
    if (std::this_thread::get_id() != thread_ || Clock::now() - last_ < kBetween) return false;
    const pybind11::gil_scoped_acquire acquired;
    if (PyErr_CheckSignals() != 0) {
        raised_ = std::make_exception_ptr(pybind11::error_already_set());
        asked_ = true;
    }
    last_ = Clock::now();
    return asked_;
}

void Interruption::check() {
    if (asked()) throw pem::Interrupted{};
}

void Interruption::raise() {
    std::rethrow_exception(raised_);
}

}  // namespace railpem::python

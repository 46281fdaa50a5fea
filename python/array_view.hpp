#pragma once
// Results as numpy arrays that look at the memory of the result: nothing is copied.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <vector>

namespace railpem::python {

/// A read-only array of that shape over the first values at `data`, which live as long as `owner`.
template <class Number>
pybind11::array_t<Number> array_view(const Number* data, std::vector<pybind11::ssize_t> shape,
                                     const pybind11::handle& owner) {
    pybind11::array_t<Number> array(std::move(shape), data, owner);
    pybind11::detail::array_proxy(array.ptr())->flags &= ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

template <class Number>
pybind11::array_t<Number> array_view(const std::vector<Number>& values, const pybind11::handle& owner) {
    return array_view(values.data(), {static_cast<pybind11::ssize_t>(values.size())}, owner);
}

}  // namespace railpem::python

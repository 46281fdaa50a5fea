#pragma once
// What the module holds, one function per part of it. Every function of the module takes the arguments of the verb of
// its name.

#include <pybind11/pybind11.h>

#include <memory>

#include "app/schema/case_file.hpp"

namespace railpem::python {

/// A case as Python holds it: changing it puts another CaseFile in its place, so results never see a half-changed case.
struct Case {
    std::shared_ptr<const app::CaseFile> file;
    std::string path;                  ///< where it was read; empty: made from a text
    std::vector<std::string> changes;  ///< as given to --set
};

void bind_errors(pybind11::module_& module);
void bind_case(pybind11::module_& module);
void bind_solve(pybind11::module_& module);
void bind_track(pybind11::module_& module);
void bind_sweep(pybind11::module_& module);
void bind_simulate(pybind11::module_& module);
void bind_inspect(pybind11::module_& module);
void bind_diagnose(pybind11::module_& module);

}  // namespace railpem::python

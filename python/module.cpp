#include <pybind11/pybind11.h>

#include <Eigen/Core>

#include "app/program_version.hpp"
#include "python/bindings.hpp"

PYBIND11_MODULE(_core, module) {
    using namespace railpem::python;
    Eigen::setNbThreads(1);  // our own team is the only one: a second beside it spins for the same cores
    module.doc() = "Vehicle-track dynamics: the verbs of railpem as functions, their results as numpy arrays.";
    module.attr("__version__") = railpem::app::program_version();
    bind_errors(module);
    bind_case(module);
    bind_solve(module);
    bind_track(module);
    bind_sweep(module);
    bind_simulate(module);
    bind_inspect(module);
    bind_diagnose(module);
}

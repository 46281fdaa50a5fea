#include "app/input_error.hpp"
#include "app/output_folder.hpp"
#include "parameters/parameter_error.hpp"
#include "python/bindings.hpp"

namespace railpem::python {

void bind_errors(pybind11::module_& module) {
    static pybind11::exception<app::InputError> input_error(module, "InputError", PyExc_ValueError);
    static pybind11::exception<app::OutputError> output_error(module, "OutputError", PyExc_OSError);
    input_error.attr("__doc__") =
        "The input was refused; the text is the message that the command line gives with exit status 2.";
    output_error.attr("__doc__") = "A result could not be written; exit status 1 on the command line.";
    // By value: pybind11 takes a function of this very type.
    // NOLINT(performance-unnecessary-value-param)
    pybind11::register_local_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) std::rethrow_exception(pointer);
        } catch (const app::InputError& error) {
            input_error(error.what());
        } catch (const parameters::ParameterError& error) {
            input_error(error.what());
        } catch (const app::OutputError& error) {
            output_error(error.what());
        }
    });
}

}  // namespace railpem::python

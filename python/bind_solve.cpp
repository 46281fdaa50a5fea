#include <fmt/format.h>
#include <pybind11/stl.h>

#include "app/plausibility/implausible_case.hpp"
#include "app/schema/nearest_key.hpp"
#include "app/schema/read_table.hpp"
#include "app/tables/response_summary.hpp"
#include "app/tables/response_tables.hpp"
#include "pem/coupling/solution.hpp"
#include "pem/coupling/solve_case.hpp"
#include "pem/lines/judged_case.hpp"
#include "pem/response_names.hpp"
#include "python/array_view.hpp"
#include "python/bindings.hpp"
#include "python/interruption.hpp"

namespace railpem::python {

namespace py = pybind11;

namespace {

/// A case solved at one speed. Where the case states its lines nothing but these is solved; summary() judges them then.
struct Response {
    pem::JudgedCase judged;
    std::vector<double> psd;  ///< [response][line]
    Case of;
};

py::ssize_t lines(const Response& self) {
    return static_cast<py::ssize_t>(self.judged.solution.frequency_hz.size());
}
py::ssize_t responses() {
    return static_cast<py::ssize_t>(pem::response_names().size());
}

std::vector<std::string> names() {
    std::vector<std::string> list;
    for (const pem::ResponseName& name : pem::response_names()) list.push_back(name.where);
    return list;
}

std::size_t index_of(const std::string& where) {
    const std::vector<std::string> known = names();
    const auto found = std::find(known.begin(), known.end(), where);
    if (found == known.end())
        throw py::key_error(fmt::format("there is no response '{}'; allowed: {}", where, app::joined(known)));
    return static_cast<std::size_t>(found - known.begin());
}

double speed_of(const app::CaseFile& file, std::optional<double> speed) {
    const std::vector<double>& own = file.parameters.running.speeds_m_per_s;
    if (!speed && own.size() == 1) return own.front();
    if (!speed)
        throw app::InputError(fmt::format("{}: has {} speeds\nallowed: solve(case, speed_m_per_s=…), one at a time",
                                          file.document.name, own.size()));
    if (!(*speed > 0.0 && *speed <= 200.0))
        throw app::InputError(
            fmt::format("speed_m_per_s: cannot be {:g}\nallowed: greater than 0, at most 200 m/s", *speed));
    return *speed;
}

std::unique_ptr<Response> solve(const Case& self, std::optional<double> speed, int threads) {
    const double speed_m_per_s = speed_of(*self.file, speed);
    return interruptible([&](Interruption& interruption) {
        auto result = std::make_unique<Response>();
        result->of = self;
        try {
            const pem::SolveOptions options{.threads = threads, .interrupted = [&] { return interruption.asked(); }};
            if (self.file->parameters.frequency.step_hz > 0.0)
                result->judged.solution = pem::solve_case(self.file->parameters, speed_m_per_s, options);
            else
                result->judged = pem::solve_judged(self.file->parameters, speed_m_per_s, options);
        } catch (const parameters::ParameterError& error) {
            throw app::refused(self.file->document, error);
        }
        for (std::size_t response = 0; response < pem::response_names().size(); ++response) {
            const std::vector<double> row = pem::response_psd(result->judged.solution, response);
            result->psd.insert(result->psd.end(), row.begin(), row.end());
        }
        return result;
    });
}

/// All amplitudes; the cross-spectral matrix of the responses is their outer product summed over the sources.
py::array_t<std::complex<double>> pseudo_response(const py::object& object) {
    const Response& self = object.cast<const Response&>();
    return array_view(self.judged.solution.pseudo_response.data(),
                      {static_cast<py::ssize_t>(self.judged.solution.source_names.size()), responses(), lines(self)},
                      object);
}

std::string summary(const Response& self) {
    const pem::CaseParameters& parameters = self.of.file->parameters;
    const bool judged = parameters.frequency.step_hz <= 0.0;
    return app::summary_text(
        *self.of.file, app::plausibility_warnings(*self.of.file, app::case_figures(*self.of.file)),
        {app::response_spectra(judged ? self.judged
                                      : pem::solve_judged(parameters, self.judged.solution.speed_m_per_s, {}))});
}

}  // namespace

void bind_solve(py::module_& module) {
    py::class_<Response>(module, "Response", "A case solved at one speed: one-sided spectra of every response.")
        .def_property_readonly("speed_m_per_s", [](const Response& self) { return self.judged.solution.speed_m_per_s; })
        .def_property_readonly("frequency_hz",
                               [](const py::object& self) {
                                   return array_view(self.cast<const Response&>().judged.solution.frequency_hz, self);
                               })
        .def_property_readonly(
            "names", [](const Response&) { return names(); }, "Responses in the order of the rows of psd.")
        .def_property_readonly(
            "columns", [](const Response&) { return app::psd_column_names(); },
            "The same with quantity and unit, as the tables name them.")
        .def_property_readonly("sources", [](const Response& self) { return self.judged.solution.source_names; })
        .def_property_readonly(
            "psd",
            [](const py::object& self) {
                const Response& response = self.cast<const Response&>();
                return array_view(response.psd.data(), {responses(), lines(response)}, self);
            },
            "[response, line] in (m/s^2)^2/Hz, forces in N^2/Hz.")
        .def(
            "__getitem__",
            [](const py::object& self, const std::string& where) {
                const Response& response = self.cast<const Response&>();
                return array_view(response.psd.data() + index_of(where) * response.judged.solution.frequency_hz.size(),
                                  {lines(response)}, self);
            },
            "The PSD of one response, \"wheel_1\" for instance.")
        .def_property_readonly("pseudo_response", &pseudo_response,
                               "[source, response, line], complex: S = sum over sources of y y^H.")
        .def_property_readonly("warnings", [](const Response& self) { return self.judged.solution.warnings; })
        .def("_summary", &summary);
    module.def("solve", &solve, py::arg("case"), py::arg("speed_m_per_s") = std::nullopt, py::arg("threads") = 0,
               "Solves a case at one speed; without a speed at its own, when it has one.");
}

}  // namespace railpem::python

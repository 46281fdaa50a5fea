#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include "app/schema/read_table.hpp"
#include "app/tables/track_tables.hpp"
#include "pem/coupling/track_response.hpp"
#include "pem/rail/case_equilibrium.hpp"
#include "python/array_view.hpp"
#include "python/bindings.hpp"
#include "python/interruption.hpp"

namespace railpem::python {

namespace py = pybind11;

namespace {

/// The track without a vehicle, with its decay rates.
struct Receptance {
    pem::TrackResponse response;
    app::NumberTable decay;
};

/// Runs `work` on the parameters of the case; what physics refuses is said with its line in the case.
template <class Work>
auto of_case(const Case& self, const Work& work) {
    return interruptible([&](Interruption&) {
        try {
            return work(self.file->parameters);
        } catch (const parameters::ParameterError& error) {
            throw app::refused(self.file->document, error);
        }
    });
}

std::unique_ptr<track::StaticEquilibrium> solve_static(const Case& self) {
    return of_case(self, [](const pem::CaseParameters& parameters) {
        return std::make_unique<track::StaticEquilibrium>(pem::case_equilibrium(parameters));
    });
}

std::unique_ptr<Receptance> receptance(const Case& self, double from_hz, double to_hz, int lines, int threads) {
    if (!(from_hz >= 0.01 && from_hz < to_hz && to_hz <= 20000.0))
        throw app::InputError("from_hz, to_hz: no such range\nallowed: 0.01 <= from_hz < to_hz <= 20000");
    if (lines < 2 || lines > 100000) throw app::InputError("lines: cannot be so many\nallowed: between 2 and 100000");
    return of_case(self, [&](const pem::CaseParameters& parameters) {
        auto result = std::make_unique<Receptance>();
        result->response = pem::track_response(parameters, pem::geometric_lines(from_hz, to_hz, lines), true, threads);
        result->decay = app::decay_table(result->response, parameters.track.spacing_m);
        return result;
    });
}

/// A property that looks at a vector of the struct.
template <class Owner, class Number>
auto view_of(std::vector<Number> Owner::*member) {
    return [member](const py::object& self) { return array_view(self.cast<const Owner&>().*member, self); };
}

template <class Number>
auto response_view(std::vector<Number> pem::TrackResponse::*member) {
    return
        [member](const py::object& self) { return array_view(self.cast<const Receptance&>().response.*member, self); };
}

auto decay_view(std::size_t column) {
    return [column](const py::object& self) {
        return array_view(self.cast<const Receptance&>().decay.columns[column], self);
    };
}

void bind_static(py::module_& module) {
    using S = track::StaticEquilibrium;
    py::class_<S>(module, "StaticEquilibrium", "Every pad under the standing car, in order of position.")
        .def_property_readonly("position_m", view_of(&S::position_m), "From the centre of the car.")
        .def_property_readonly("deflection_m", view_of(&S::compression_m),
                               "Total compression of the pad, clip preload included.")
        .def_property_readonly("static_stiffness_n_per_m", view_of(&S::static_stiffness_n_per_m))
        .def_property_readonly("dynamic_stiffness_n_per_m", view_of(&S::dynamic_stiffness_n_per_m),
                               "At the reference frequency.")
        .def_property_readonly("warnings", [](const S& self) { return self.warnings; });
    module.def("static", &solve_static, py::arg("case"),
               "Compression and stiffness of every pad under the standing vehicle.");
}

}  // namespace

void bind_track(py::module_& module) {
    bind_static(module);
    using T = pem::TrackResponse;
    py::class_<Receptance>(module, "Receptance", "The track without a vehicle, at rest.")
        .def_property_readonly("frequency_hz", response_view(&T::frequency_hz))
        .def_property_readonly("over_pad_m_per_n", response_view(&T::over_pad))
        .def_property_readonly("mid_bay_m_per_n", response_view(&T::mid_bay))
        .def_property_readonly("decay_centre_hz", decay_view(0))
        .def_property_readonly("decay_rate_db_per_m", decay_view(1), "EN 15461, in third-octaves.")
        .def_property_readonly("bloch_decay_rate_db_per_m", decay_view(2));
    module.def("receptance", &receptance, py::arg("case"), py::arg("from_hz") = 20.0, py::arg("to_hz") = 5000.0,
               py::arg("lines") = 1500, py::arg("threads") = 0,
               "Point receptances over a pad and in the middle of a bay, and decay rates.");
}

}  // namespace railpem::python

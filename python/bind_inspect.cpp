#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

#include "app/schema/nearest_key.hpp"
#include "app/schema/recording_schema.hpp"
#include "app/verbs/inspection_beliefs.hpp"
#include "python/array_view.hpp"
#include "python/bindings.hpp"
#include "python/interruption.hpp"
#include "recordings/inspection/inspect.hpp"
#include "recordings/inspection/inspection_words.hpp"
#include "recordings/inspection/inspection_writers.hpp"

namespace railpem::python {

namespace py = pybind11;

namespace {

using Report = recordings::InspectionReport;

std::unique_ptr<Report> inspect(const std::filesystem::path& path, const Case* believed) {
    return interruptible([&](Interruption&) {
        const app::RecordingFile file = app::read_recording(path.string());
        const recordings::InspectionContext context =
            believed ? app::inspection_beliefs(*believed->file, file) : recordings::InspectionContext{};
        return app::reading_data(file, [&] {
            return std::make_unique<Report>(recordings::inspect_file(file.description, file.base, context));
        });
    });
}

std::vector<std::string> inspected_channels(const Report& self) {
    std::vector<std::string> list;
    for (const recordings::ChannelInspection& channel : self.channels) list.push_back(channel.description.name);
    return list;
}

py::array_t<double> psd(const py::object& object, const std::string& name) {
    const Report& self = object.cast<const Report&>();
    for (const recordings::ChannelInspection& channel : self.channels)
        if (channel.description.name == name) return array_view(channel.psd, object);
    throw py::key_error("there is no channel '" + name + "'; allowed: " + app::joined(inspected_channels(self)));
}

std::vector<std::string> faults(const Report& self) {
    std::vector<std::string> list;
    for (const recordings::Fault& fault : self.faults) list.push_back(fault.says);
    return list;
}

}  // namespace

void bind_inspect(py::module_& module) {
    py::class_<Report>(module, "Inspection", "What a recording holds and whether it can be trusted.")
        .def_property_readonly("verdict", &recordings::verdict_of, "One sentence.")
        .def_property_readonly("faults", &faults, "What is wrong or remarkable, errors first.")
        .def_property_readonly("names", &inspected_channels)
        .def_property_readonly("duration_s", [](const Report& self) { return self.duration_s; })
        .def_property_readonly("sampling_rate_hz", [](const Report& self) { return self.sampling_rate_hz; })
        .def_property_readonly(
            "frequency_hz",
            [](const py::object& self) { return array_view(self.cast<const Report&>().frequency_hz, self); })
        .def("__getitem__", &psd, "One-sided PSD of a channel on frequency_hz, SI unit squared per Hz.")
        .def("text", &recordings::to_text, "The screen of text that `railpem inspect` prints.")
        .def("html", &recordings::to_html, "A page that needs nothing beside it.")
        .def("_json", [](const Report& self) { return recordings::to_json(self).dump(); });
    module.def("inspect", &inspect, py::arg("recording"), py::arg("case").none(true) = nullptr,
               "Looks at a recording (a folder or a description), with what a believed case says about it. Ctrl-C "
               "takes effect at its end.");
}

}  // namespace railpem::python

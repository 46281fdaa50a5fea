#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/schema/case_value.hpp"
#include "python/bindings.hpp"

namespace railpem::python {

namespace py = pybind11;

namespace {

Case read(const std::filesystem::path& path, const std::vector<std::string>& set) {
    return {std::make_shared<app::CaseFile>(app::read_case(path.string(), set)), path.string(), set};
}

Case parse(const std::string& text, const std::string& name) {
    return {std::make_shared<app::CaseFile>(app::parse_case(name, text, {})), "", {}};
}

/// The case after further options; all of them or none.
Case changed(const Case& from, const std::vector<std::string>& options) {
    Case result{std::make_shared<app::CaseFile>(app::changed_case(*from.file, options)), from.path, from.changes};
    result.changes.insert(result.changes.end(), options.begin(), options.end());
    return result;
}

parameters::Value value(const Case& self, const std::string& key) {
    if (const auto found = app::case_value(*self.file, key)) return *found;
    throw app::unknown_case_key(*self.file, key);
}

std::vector<double> speeds(const Case& self) {
    return self.file->parameters.running.speeds_m_per_s;
}

}  // namespace

void bind_case(py::module_& module) {
    py::class_<Case>(module, "Case", "A case: vehicle, track, contact, irregularity, speeds and frequency lines.")
        .def(py::init(&read), py::arg("path"), py::arg("set") = std::vector<std::string>{},
             "Reads a case file; `set`: options as on the command line, \"key=value\".")
        .def_static("from_toml", &parse, py::arg("text"), py::arg("name") = "case",
                    "A case from the text of a case file, called `name` in messages.")
        .def("_changed", &changed, py::arg("options"))
        .def(
            "_become", [](Case& self, const Case& other) { self = other; }, py::arg("other"))
        .def("_value", &value, py::arg("key"))
        .def(
            "keys", [](const Case& self) { return app::case_keys(*self.file); },
            "Every dotted key that has a value in this case.")
        .def(
            "to_toml", [](const Case& self) { return app::write_case(self.file->without_effects, self.file->effects); },
            "The case as the text of a case file that reads back to the same values.")
        .def(
            "copy", [](const Case& self) { return self; }, "A case of its own with the same values.")
        .def_property_readonly(
            "name", [](const Case& self) { return self.file->name; }, "What the files of its results are called after.")
        .def_property_readonly("speeds_m_per_s", &speeds)
        .def("__repr__", [](const Case& self) { return fmt::format("<railpem.Case {}>", self.file->name); });
}

}  // namespace railpem::python

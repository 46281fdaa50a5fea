#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/output_folder.hpp"
#include "app/schema/hide_option.hpp"
#include "app/schema/nearest_key.hpp"
#include "app/tables/simulated_recording_files.hpp"
#include "app/verbs/simulation_request.hpp"
#include "python/array_view.hpp"
#include "python/bindings.hpp"
#include "python/interruption.hpp"

namespace railpem::python {

namespace py = pybind11;

namespace {

/// A recording marched in time, and what was hidden in it.
struct Recording {
    simulate::Recording recording;
    app::Truth truth;
};

std::unique_ptr<Recording> simulate_recording(const Case& self, app::SimulationRequest request) {
    request.path = self.path;
    request.set = self.changes;
    return interruptible([&](Interruption& interruption) {
        app::check_simulation(request);
        auto result = std::make_unique<Recording>();
        result->truth = app::planned_simulation(*self.file, request);
        result->recording =
            app::run_simulation(*self.file, result->truth, [&](double, double) { interruption.check(); });
        return result;
    });
}

std::vector<std::string> recorded_channels(const Recording& self) {
    std::vector<std::string> list;
    for (const simulate::Channel& channel : self.recording.channels) list.push_back(channel.name);
    return list;
}

py::array_t<double> channel(const py::object& object, const std::string& name) {
    const Recording& self = object.cast<const Recording&>();
    for (const simulate::Channel& channel : self.recording.channels)
        if (channel.name == name) return array_view(channel.acceleration_m_per_s2, object);
    throw py::key_error("there is no channel '" + name + "'; allowed: " + app::joined(recorded_channels(self)));
}

std::filesystem::path save_recording(const Recording& self, const std::filesystem::path& folder) {
    app::OutputFolder output(folder, "save", {app::Overwrite::anything, app::program_provenance});
    app::write_simulated_recording(output, self.recording, app::RecordingFormat::csv);
    output.commit();
    return folder;
}

}  // namespace

void bind_simulate(py::module_& module) {
    py::class_<Recording>(module, "Recording", "What nine accelerometers would have recorded.")
        .def_property_readonly("sampling_rate_hz",
                               [](const Recording& self) { return self.recording.sampling_rate_hz; })
        .def_property_readonly("speed_m_per_s", [](const Recording& self) { return self.recording.speed_m_per_s; })
        .def_property_readonly("names", &recorded_channels)
        .def("__getitem__", &channel, "Acceleration of a channel in m/s^2, \"axlebox_1\" for instance.")
        .def("__len__", [](const Recording& self) { return self.recording.samples(); })
        .def("save", &save_recording, py::arg("folder"), py::call_guard<py::gil_scoped_release>(),
             "recording.toml and recording.csv in the folder, as `railpem simulate` writes them; gives the folder.")
        .def("_truth", [](const Recording& self) { return app::truth_text(self.truth, self.recording); });
    module.def(
        "_simulate",
        [](const Case& self, double seconds, std::int64_t seed, std::vector<std::string> hide,
           std::optional<double> speed, double rate_hz, double noise, double speed_fluctuation, bool standing,
           bool force, std::string profile, std::optional<std::int64_t> profile_seed, double profile_length_m) {
            return simulate_recording(self, {.hide = std::move(hide),
                                             .profile = std::move(profile),
                                             .seconds = seconds,
                                             .seed = seed,
                                             .speed = speed,
                                             .profile_seed = profile_seed,
                                             .rate_hz = rate_hz,
                                             .noise = noise,
                                             .speed_fluctuation = speed_fluctuation,
                                             .profile_length_m = profile_length_m,
                                             .force = force,
                                             .standing = standing});
        },
        py::arg("case"), py::arg("seconds"), py::arg("seed"), py::arg("hide"), py::arg("speed_m_per_s"),
        py::arg("rate_hz"), py::arg("noise"), py::arg("speed_fluctuation"), py::arg("standing"), py::arg("force"),
        py::arg("profile"), py::arg("profile_seed"), py::arg("profile_length_m"));
    module.def("hidden_effects", &app::effects_list,
               "Every effect that simulate can hide, with its parameters and ranges, as text.");
}

}  // namespace railpem::python

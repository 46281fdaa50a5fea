#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/output_folder.hpp"
#include "app/plausibility/implausible_case.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/schema/diagnosed_case.hpp"
#include "app/tables/diagnosis_json.hpp"
#include "app/verbs/run_diagnosis.hpp"
#include "python/array_view.hpp"
#include "python/bindings.hpp"
#include "python/interruption.hpp"

namespace railpem::python {

namespace py = pybind11;

namespace {

struct Diagnosis {
    diagnosis::Diagnosis result;
    app::DiagnosisRequest request;
};

std::unique_ptr<Diagnosis> diagnose(const Case& believed, const std::vector<std::filesystem::path>& paths,
                                    double window_s, double held_out, int most_effects,
                                    const std::vector<std::string>& without, int threads) {
    if (!(window_s >= 0.25 && window_s <= 60.0))
        throw app::InputError("window_s: no such window\nallowed: between 0.25 and 60 s");
    if (!(held_out >= 0.1 && held_out <= 0.5))
        throw app::InputError("held_out: no such share\nallowed: between 0.1 and 0.5");
    if (most_effects < 1 || most_effects > 4)
        throw app::InputError("most_effects: cannot be so many\nallowed: between 1 and 4");
    if (paths.empty()) throw app::InputError("recordings: there is none\nallowed: at least one");
    app::DiagnosisRequest request{.case_path = believed.path,
                                  .recordings = {},
                                  .without = without,
                                  .set = believed.changes,
                                  .window_s = window_s,
                                  .held_out = held_out,
                                  .threads = threads,
                                  .most_effects = most_effects};
    for (const std::filesystem::path& path : paths) request.recordings.push_back(path.string());
    request.doubts = app::plausibility_warnings(*believed.file, app::case_figures(*believed.file));
    return interruptible([&](Interruption& interruption) {
        auto result = std::make_unique<Diagnosis>();
        const app::DiagnosisObserver observer{.progress = [](double) {},
                                              .interrupted = [&] { return interruption.asked(); }};
        result->result = app::run_diagnosis(*believed.file, request, observer, [] {});
        result->request = request;
        return result;
    });
}

/// Spectra of one channel of one recording, as arrays that look at the result.
py::dict comparison(const py::object& object, const diagnosis::ChannelComparison& channel) {
    py::dict all;
    all["recording"] = channel.recording;
    all["channel"] = channel.channel;
    all["quantity"] = channel.quantity;
    all["speed_m_per_s"] = channel.speed_m_per_s;
    all["frequency_hz"] = array_view(channel.frequency_hz, object);
    all["measured"] = array_view(channel.measured, object);
    all["low"] = array_view(channel.low, object);
    all["high"] = array_view(channel.high, object);
    all["believed"] = array_view(channel.believed, object);
    all["retuned"] = array_view(channel.retuned, object);
    all["diagnosed"] = array_view(channel.diagnosed, object);
    return all;
}

py::list channels(const py::object& object) {
    py::list list;
    for (const diagnosis::ChannelComparison& channel : object.cast<const Diagnosis&>().result.channels)
        list.append(comparison(object, channel));
    return list;
}

std::filesystem::path save_diagnosis(const Diagnosis& self, const std::filesystem::path& folder) {
    std::vector<std::string> read = self.request.recordings;
    if (!self.request.case_path.empty()) read.insert(read.begin(), self.request.case_path);
    app::OutputFolder output(folder, "save",
                             {app::Overwrite::anything, [&] { return app::call_provenance(read, self.request.set); }});
    app::write_diagnosis(output, self.result, self.request);
    output.commit();
    return folder;
}

}  // namespace

void bind_diagnose(py::module_& module) {
    py::class_<Diagnosis>(module, "Diagnosis", "What a believed case left out, told from recordings.")
        .def_property_readonly(
            "verdict", [](const Diagnosis& self) { return diagnosis::verdict_name(self.result.verdict); },
            "consistent, explained, ambiguous, unexplained or recording-fault.")
        .def_property_readonly("statement", [](const Diagnosis& self) { return self.result.statement; })
        .def_property_readonly(
            "channels", &channels,
            "Per recording and channel: measured (with low and high), believed, retuned and diagnosed spectra.")
        .def(
            "diagnosed_toml", [](const Diagnosis& self) { return app::diagnosed_case_text(self.result); },
            "The case with the named physics; its irregularity is a file that save_diagnosis() writes beside it.")
        .def("save", &save_diagnosis, py::arg("folder"), "Every file that `railpem diagnose` writes; gives the folder.")
        .def("_json", [](const Diagnosis& self) { return app::diagnosis_json(self.result); });
    module.def("_diagnose", &diagnose, py::arg("case"), py::arg("recordings"), py::arg("window_s"), py::arg("held_out"),
               py::arg("most_effects"), py::arg("without"), py::arg("threads"));
}

}  // namespace railpem::python

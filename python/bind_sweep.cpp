#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/output_folder.hpp"
#include "app/schema/sweep_schema.hpp"
#include "app/tables/sweep_table.hpp"
#include "pem/lines/sweep.hpp"
#include "python/array_view.hpp"
#include "python/bindings.hpp"
#include "python/interruption.hpp"

namespace railpem::python {

namespace py = pybind11;

namespace {

/// A sweep that has run: one row of values per case.
struct Sweep {
    app::SweepFile file;
    std::vector<pem::SweepRow> rows;
    std::vector<double> parameters;  ///< [case][axis]
    std::vector<double> values;      ///< [case][row]

    py::ssize_t cases() const { return static_cast<py::ssize_t>(pem::sweep_size(file.plan)); }
};

void put_parameters(Sweep& sweep) {
    for (std::size_t index = 0; index < pem::sweep_size(sweep.file.plan); ++index) {
        const std::vector<double> values = pem::sweep_values(sweep.file.plan, index);
        sweep.parameters.insert(sweep.parameters.end(), values.begin(), values.end());
    }
}

std::unique_ptr<Sweep> run(const std::function<app::SweepFile()>& read, int threads) {
    return interruptible([&](Interruption& interruption) {
        auto sweep = std::make_unique<Sweep>();
        sweep->file = read();
        sweep->rows = pem::sweep_rows(sweep->file.plan);
        put_parameters(*sweep);
        const std::size_t rows = sweep->rows.size();
        sweep->values.resize(pem::sweep_size(sweep->file.plan) * rows);
        // Every case has its own place, so threads do not meet.
        const auto done = [&](std::size_t index, const std::vector<double>& values) {
            std::copy(values.begin(), values.end(), sweep->values.begin() + static_cast<std::ptrdiff_t>(index * rows));
            interruption.check();
        };
        pem::run_sweep(sweep->file.plan, threads,
                       {.finished = [](std::size_t) { return false; }, .done = done, .next = {}});
        return sweep;
    });
}

std::unique_ptr<Sweep> sweep_file(const std::filesystem::path& path, const std::vector<std::string>& set, int threads) {
    return run([&] { return app::read_sweep(path.string(), set); }, threads);
}

std::unique_ptr<Sweep> sweep_text(const Case& base, const std::string& text, int threads) {
    return run([&] { return app::parse_sweep(base.file->name, text, base.file->parameters); }, threads);
}

std::vector<std::string> keys(const Sweep& self) {
    std::vector<std::string> list;
    for (const pem::SweepAxis& axis : self.file.plan.axes) list.push_back(axis.key);
    return list;
}

py::list rows(const Sweep& self) {
    py::list list;
    for (const pem::SweepRow& row : self.rows)
        list.append(py::make_tuple(row.speed_m_per_s, row.quantity, row.response, row.frequency_hz));
    return list;
}

void write_csv(const Sweep& self, const std::filesystem::path& path) {
    const std::size_t rows = self.rows.size();
    const auto block = [&](std::size_t first, std::size_t count) {
        const auto begin = self.values.begin() + static_cast<std::ptrdiff_t>(first * rows);
        return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(count * rows));
    };
    app::OutputFolder folder(path.parent_path(), "write_csv");
    folder.write_by(path.filename().string(), [&](const std::filesystem::path& file) {
        app::write_sweep_csv(file, self.file.plan, block, app::stamped(".csv", "", app::program_provenance()));
    });
    folder.commit();
}

}  // namespace

void bind_sweep(py::module_& module) {
    py::class_<Sweep>(module, "Sweep", "Many cases, a few quantities of each.")
        .def_property_readonly("keys", &keys, "The varied keys: columns of parameters.")
        .def_property_readonly(
            "parameters",
            [](const py::object& self) {
                const Sweep& sweep = self.cast<const Sweep&>();
                return array_view(sweep.parameters.data(),
                                  {sweep.cases(), static_cast<py::ssize_t>(sweep.file.plan.axes.size())}, self);
            },
            "[case, key]")
        .def_property_readonly("rows", &rows,
                               "(speed_m_per_s, quantity, response, frequency_hz) of every column of values; NaN where "
                               "there is no frequency.")
        .def_property_readonly(
            "values",
            [](const py::object& self) {
                const Sweep& sweep = self.cast<const Sweep&>();
                return array_view(sweep.values.data(), {sweep.cases(), static_cast<py::ssize_t>(sweep.rows.size())},
                                  self);
            },
            "[case, row]")
        .def("write_csv", &write_csv, py::arg("path"), py::call_guard<py::gil_scoped_release>(),
             "The long table that `railpem sweep` writes, bit for bit.")
        .def("__len__", &Sweep::cases);
    module.def("_sweep_file", &sweep_file, py::arg("path"), py::arg("set"), py::arg("threads"));
    module.def("_sweep_text", &sweep_text, py::arg("case"), py::arg("text"), py::arg("threads"));
}

}  // namespace railpem::python

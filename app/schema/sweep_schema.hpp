#pragma once
// The sweep file: which case, which of its numbers vary and how, what is kept of every case.

#include <string>
#include <vector>

#include "app/refusals.hpp"
#include "app/schema/document.hpp"
#include "app/schema/schema.hpp"
#include "pem/case_parameters.hpp"
#include "pem/lines/sweep.hpp"

namespace railpem::app {

/// [[vary]] of a sweep file.
struct VarySection {
    std::string key;
    std::vector<double> values;
    double from = 0.0, to = 0.0;
    int count = 0;  ///< with from and to: so many values, ends included; 0 in a Latin hypercube
    bool logarithmic = false;
};

/// [[keep]] of a sweep file.
struct KeepSection {
    std::string response;
    pem::QuantityKind quantity = pem::QuantityKind::rms;
};

enum class TableFormat { automatic, csv, hdf5 };

struct SweepDescription {
    std::string title;
    std::string case_path;
    pem::Design design = pem::Design::grid;
    int samples = 0;
    int seed = 1;
    TableFormat format = TableFormat::automatic;
    std::vector<VarySection> vary;
    std::vector<KeepSection> keep;
};

/// The schema of a sweep file, bound to SweepDescription.
const TableSchema& sweep_schema();
std::string describe_sweep();

/// A sweep ready to run.
struct SweepFile {
    std::string name;
    SweepDescription description;
    pem::SweepPlan plan;
};

/// Reads a sweep and its case (with options `--set` applied to it), and checks every combination of the varied values
/// before anything runs. Throws InputError that names the file, the line and, where a combination is impossible, the
/// combination.
SweepFile read_sweep(const std::string& path, const std::vector<std::string>& options, Refuse refuse = Refuse::first);

/// The same for a text that is already there, called `name` in messages, over a case that is already read: what the
/// text says under `case` is not opened.
SweepFile parse_sweep(const std::string& name, const std::string& text, const pem::CaseParameters& base);

}  // namespace railpem::app

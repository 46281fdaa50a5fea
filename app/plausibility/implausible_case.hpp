#pragma once
// Values that are allowed and hardly believed.

#include <string>
#include <vector>

#include "app/plausibility/case_figures.hpp"
#include "app/schema/case_file.hpp"
#include "pem/lines/sweep.hpp"

namespace railpem::app {

/// A number of the case, or a figure that follows from it, out of its believed range.
struct Implausible {
    std::string key;   ///< dotted, as in the file; empty for a figure
    std::string says;  ///< "track.rail.youngs_modulus_pa = 210 Pa is hardly believed: … GPa?"
};

/// Numbers of the case against believed_ranges(), in the order of the schema.
std::vector<Implausible> implausible_values(const pem::CaseParameters& parameters);

/// Figures of the case against believed_figures().
std::vector<Implausible> implausible_figures(const pem::CaseParameters& parameters, const CaseFigures& figures);

/// One figure, by the name it has in believed_figures(); nothing where it is believed.
std::vector<Implausible> implausible_figure(const std::string& name, double value, const std::string& unit,
                                            const std::string& slip);

/// Both, each with the file and the line of its value. What already has a value out of range in it is not said again:
/// figures are looked at only where all numbers are believed.
std::vector<std::string> plausibility_warnings(const CaseFile& file, const CaseFigures& figures);

/// Numbers of the case of a sweep, and every value that they take, each said once; `name` is the sweep's.
std::vector<std::string> sweep_warnings(const std::string& name, const pem::SweepPlan& plan);

/// "warning: …" on stderr; with `strict` nothing is said and all of them are one InputError. Nothing without
/// warnings.
void say_or_refuse(const std::vector<std::string>& warnings, bool strict);

}  // namespace railpem::app

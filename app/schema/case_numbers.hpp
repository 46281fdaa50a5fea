#pragma once

#include <functional>
#include <string>
#include <vector>

#include "parameters/field.hpp"
#include "pem/case_parameters.hpp"

namespace railpem::app {

/// A number of a case by its dotted key, elements of lists stated: "irregularity.band[1].exponent".
struct CaseNumber {
    std::string key;
    parameters::Description description;
    double tolerance = 0.0;  ///< relative standard deviation: the case's own, else the field's
    std::function<double(const pem::CaseParameters&)> get;
    std::function<void(pem::CaseParameters&, double)> set;  ///< the value must lie in description.range
};

/// Every number that the case has, in the order of the schema; integers, lists and switches are not among them. Lists
/// of tables count as they are in this case.
std::vector<CaseNumber> case_numbers(const pem::CaseParameters& parameters);

}  // namespace railpem::app

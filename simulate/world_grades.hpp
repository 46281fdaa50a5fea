#pragma once
// The grades of the marched world and what each of its numbers means.

#include <string>
#include <vector>

#include "simulate/world_parameters.hpp"

namespace railpem::simulate {

/// A number of the world as a user may set it.
struct WorldKey {
    std::string name;
    double WorldParameters::*member;
    std::string unit;   ///< "1": none
    double good, worn;  ///< the ideal one is the member's own default
    double low, high;   ///< allowed
    std::string says;
    std::string source;  ///< where the values of the grades come from
};

const std::vector<WorldKey>& world_keys();

/// Names of the grades, from the best on: ideal, good, worn.
const std::vector<std::string>& world_grades();

/// The parameters of a grade, which must be one of world_grades().
WorldParameters world_of_grade(const std::string& grade);

}  // namespace railpem::simulate

#pragma once
// `--world GRADE[:key=value,…]` of `railpem simulate` and `railpem prove`.

#include <string>

#include "simulate/world_grades.hpp"

namespace railpem::app {

/// A grade with what is set beside it.
struct World {
    std::string grade = "ideal";
    simulate::WorldParameters parameters;  ///< of the grade, with what was set

    bool is_ideal() const { return parameters == simulate::WorldParameters{}; }
    /// "good", or "good (changed)" where a number is not the grade's.
    std::string name() const;
};

/// Reads the option; empty text is the ideal world. Throws InputError for a grade or key that does not exist, with the
/// nearest, and for a value outside its range.
World read_world_option(const std::string& text);

/// Part of `railpem simulate --list`: every number of a world with its unit, its value in each grade, its range and the
/// source of the values.
std::string world_list();

}  // namespace railpem::app

#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace railpem::app {

/// The input was refused: the program ends with exit status 2. what() is the whole message for the user.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Where something stands in the input: a piece of one line of a file, or a command-line option.
struct Place {
    std::string option;      ///< "--set vehicle.body_mass_kg=-5"; empty: in the file
    std::size_t line = 0;    ///< from 1; 0: the file as a whole
    std::size_t column = 0;  ///< from 1, in code points
    std::size_t length = 1;  ///< code points marked by carets
};

/// What is wrong, what would be right, and the nearest right key. The last two may be empty.
struct Problem {
    std::string what;
    std::string allowed;
    std::string hint;
};

/// The one message of a refused input: place, problem, and `source_line` with carets under the place.
///
///     case.toml:12:1: unknown key 'body_mas_kg' in [vehicle]
///       12 | body_mas_kg = 38500
///          | ^^^^^^^^^^^
///     allowed: body_mass_kg, …
///     did you mean 'body_mass_kg'?
InputError input_error(const std::string& file, const std::string& source_line, const Place& place,
                       const Problem& problem);

}  // namespace railpem::app

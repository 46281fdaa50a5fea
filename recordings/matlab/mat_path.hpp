#pragma once

#include <string>
#include <vector>

#include "recordings/matlab/mat_value.hpp"

namespace railpem::recordings {

/// The channel that a description calls `path`: a variable, fields `.f`, elements `(2)`, `{2}`, `(2,1)`, and for a
/// matrix `:3`, its third channel (the shorter side counts channels), `(:,3)` a column or `(3,:)` a row.
/// Adds to `notes` when the rows of a matrix were taken for channels. Throws ReadError, saying what stands there.
MatColumn find_mat_column(const std::vector<MatVariable>& variables, const std::string& path, const std::string& file,
                          std::vector<std::string>& notes);

/// Paths of all values of numbers, in the order of the file.
std::vector<std::string> mat_number_paths(const std::vector<MatVariable>& variables);

/// Paths of every channel of every vector and matrix of numbers (one number alone is a setting, not a channel).
std::vector<std::string> mat_channel_paths(const std::vector<MatVariable>& variables);

}  // namespace railpem::recordings

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "recordings/files/data_table.hpp"
#include "recordings/matlab/mat_value.hpp"

namespace railpem::recordings {

/// Deeper, wider or longer than anything that was measured: a file that only costs time.
inline constexpr int most_mat_levels = 32;
inline constexpr std::size_t most_mat_values = 100000, longest_mat_name = 4096;

/// An open MATLAB file: what it holds, and the numbers of its channels by blocks. All members throw ReadError.
class MatFile {
  public:
    virtual ~MatFile() = default;
    const std::vector<MatVariable>& variables() const { return variables_; }
    /// Appends the numbers `begin` to `begin + count` of every channel to its column.
    virtual void read(const std::vector<MatColumn>& channels, std::size_t begin, std::size_t count,
                      std::vector<std::vector<double>>& columns) = 0;

  protected:
    std::vector<MatVariable> variables_;
};

/// Version 4: matrices one after the other (MathWorks, "MAT-File Format", chapter 2).
std::unique_ptr<MatFile> open_mat4(const std::string& file);
/// Version 5, which is also that of 6 and 7: tagged elements, whole or deflated (the same, chapter 1).
std::unique_ptr<MatFile> open_mat5(const std::string& file);
/// Version 7.3: HDF5, with the class of a value in the attribute MATLAB_class. Also of other programs that leave out
/// what MATLAB can do without.
std::unique_ptr<MatFile> open_mat73(const std::string& file);

}  // namespace railpem::recordings

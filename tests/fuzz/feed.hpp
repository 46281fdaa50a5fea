#pragma once
// Everything that reads what a user brings, fed with arbitrary bytes.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace railpem::fuzz {

/// Where the libraries for MAT, HDF5 and WAV files run: in a child process, as the program lets them, or in this one,
/// where a fuzzer sees what they do.
enum class Libraries { in_child, in_this_process };

/// What can be fed: "csv", "text", "irregularity", "uff", "mat", "hdf5", "wav", "recording", "case", "sweep".
const std::vector<std::string>& input_kinds();

/// Feeds the bytes to the reader of this kind. True: it made something of them; false: it refused them in words.
/// Throws std::logic_error when it refused them without saying what is wrong and what is allowed, and whatever else
/// the reader throws: each is a finding.
bool feed(std::string_view kind, std::span<const char> bytes, Libraries libraries);

}  // namespace railpem::fuzz

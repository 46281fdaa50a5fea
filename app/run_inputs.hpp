#pragma once
// Which files this process has read: they are named in what it writes, and never written over.

#include <filesystem>
#include <string>
#include <vector>

namespace railpem::app {

/// Remembers a file that is read, from any thread. What is no file (a folder, nothing) is left out.
void note_input(const std::filesystem::path& file);

/// All of them, in the order in which they were first read.
std::vector<std::filesystem::path> noted_inputs();

}  // namespace railpem::app

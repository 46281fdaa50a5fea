#pragma once

#include <string>

namespace railpem::app {

/// What every file that the program writes holds in its stamp.
inline constexpr const char* kProgramStamp = "written by railpem";

/// "0.1.0": the version of the build, as CHANGELOG.md counts it.
std::string program_version();

/// "0.1.0 (commit 1a2b3c4)", with "+" behind a commit that files differ from; "0.1.0" where no repository was at hand.
std::string program_version_with_commit();

}  // namespace railpem::app

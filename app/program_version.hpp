#pragma once

#include <string>

namespace railpem::app {

/// "0.1.0": the version of the build, as CHANGELOG.md counts it.
std::string program_version();

}  // namespace railpem::app

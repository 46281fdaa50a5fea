#include "app/program_version.hpp"

#include "program_commit.hpp"  // made at every build by scripts/commit.cmake

namespace railpem::app {

std::string program_version() {
    return RAILPEM_VERSION;
}

std::string program_version_with_commit() {
    const std::string commit = RAILPEM_COMMIT;
    return program_version() + (commit.empty() ? "" : " (commit " + commit + ")");
}

}  // namespace railpem::app

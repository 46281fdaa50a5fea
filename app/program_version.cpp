#include "app/program_version.hpp"

namespace railpem::app {

std::string program_version() {
    return RAILPEM_VERSION;
}

}  // namespace railpem::app

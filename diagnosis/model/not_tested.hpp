#pragma once

#include <string>

namespace railpem::diagnosis {

/// An effect that could not be tested, and why.
struct NotTested {
    std::string effect;
    std::string why;
};

}  // namespace railpem::diagnosis

#include "diagnosis/judge/verdict_kind.hpp"

#include <cassert>
#include <iterator>

namespace railpem::diagnosis {

std::string verdict_name(Verdict verdict) {
    static const char* const names[] = {"consistent", "explained", "ambiguous", "unexplained", "recording-fault"};
    assert(static_cast<std::size_t>(verdict) < std::size(names));
    return names[static_cast<std::size_t>(verdict)];
}

}  // namespace railpem::diagnosis

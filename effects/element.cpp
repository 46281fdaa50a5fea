#include "effects/element.hpp"

#include <array>
#include <cassert>
#include <string_view>

namespace railpem::effects {

namespace {

constexpr auto kNames = std::to_array<std::string_view>(
    {"secondary", "primary", "body", "bogie", "wheel", "contact", "rail", "pad", "support", "irregularity", "sensor"});

}  // namespace

std::string element_name(Element element) {
    assert(static_cast<std::size_t>(element) < kNames.size());
    return std::string(kNames[static_cast<std::size_t>(element)]);
}

}  // namespace railpem::effects

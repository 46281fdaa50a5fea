#include "diagnosis/effects/element.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace railpem::diagnosis {

namespace {

/// Beginnings of keys; the first that fits decides.
constexpr auto kKeys = std::to_array<std::pair<std::string_view, Element>>({
    {"vehicle.primary.", Element::primary},
    {"vehicle.secondary.", Element::secondary},
    {"vehicle.bogie_distance", Element::body},  // where the body stands on its bogies
    {"vehicle.bogie", Element::bogie},
    {"vehicle.wheelbase", Element::bogie},
    {"vehicle.wheel", Element::wheel},
    {"vehicle.", Element::body},
    {"track.rail", Element::rail},
    {"track.pads.", Element::pad},
    {"track.failed_fasteners", Element::pad},
    {"track.static.", Element::pad},  // the static equilibrium is felt through the pads only
    {"track.", Element::support},
    {"contact.", Element::contact},
    {"wheel_out_of_roundness", Element::wheel},
    {"sensor", Element::sensor},
});

}  // namespace

Element element_of_key(const std::string& key) {
    for (const auto& [beginning, element] : kKeys)
        if (key.starts_with(beginning)) return element;
    return Element::irregularity;  // what is left excites: irregularity, sleeper passing, the running of the train
}

}  // namespace railpem::diagnosis

#pragma once

#include <string>
#include <vector>

#include "diagnosis/effects/element.hpp"

namespace railpem::diagnosis {

/// A set of effects with its posterior probability. {}: nothing is missing; {"unknown"}: something without a name.
struct EffectSet {
    std::vector<std::string> effects;
    double probability = 0.0;
};

/// How much a free correction at a place of the structure would explain.
struct PlaceEvidence {
    Element element = Element::body;
    double probability = 0.0;
    double nats = 0.0;
    bool forces = false;        ///< what helps there most are forces of its own, which no linear law makes
    double resonance_hz = 0.0;  ///< support: at which what each wheel meets by itself resonates; 0: it is not known to
};

}  // namespace railpem::diagnosis

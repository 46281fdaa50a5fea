#pragma once
// The simulation that somebody believed, as the diagnosis needs it.

#include <string>
#include <vector>

#include "diagnosis/effects/effect.hpp"
#include "diagnosis/effects/element.hpp"
#include "parameters/field.hpp"
#include "pem/case_parameters.hpp"
#include "recordings/measured_irregularity.hpp"

namespace railpem::diagnosis {

/// A number of the case that retuning may move.
struct BelievedNumber {
    std::string key;         ///< dotted, as in the file
    double value = 0.0;      ///< as believed
    double tolerance = 0.0;  ///< relative standard deviation, > 0
    Element element = Element::body;
    parameters::Range range;
    std::string unit;
    parameters::Nature nature = parameters::Nature::other;
};

/// The believed case: its numbers, the effects that it states itself, and access to its numbers by key.
struct BelievedCase {
    pem::CaseParameters numbers;          ///< as the file states them, before its effects
    std::vector<EffectInstance> effects;  ///< stated by the case
    ParameterAccess access;
    std::vector<BelievedNumber> uncertain;  ///< those with a tolerance
    /// of the section that was run over, where recordings bring one
    std::vector<recordings::MeasuredIrregularity> measured_irregularity;
};

}  // namespace railpem::diagnosis

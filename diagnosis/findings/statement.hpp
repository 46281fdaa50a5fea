#pragma once
// What a diagnosis says in plain words.

#include <string>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::diagnosis {

/// One paragraph: the verdict, what is named with its values and intervals, and by how much it improves on retuning; or
/// where something is missing, or what would decide. Everything else of the diagnosis has to be there.
std::string statement_of(const Diagnosis& diagnosis);

/// Values and choices of an effect that are stated, parameters in the order of the catalogue: a choice may stand in the
/// place of one.
std::string values_in_words(const EffectInstance& instance);

}  // namespace railpem::diagnosis

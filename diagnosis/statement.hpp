#pragma once
// What a diagnosis says in plain words.

#include <string>

#include "diagnosis/diagnosis.hpp"

namespace railpem::diagnosis {

/// One paragraph: the verdict, what is named with its values and intervals, and by how much it improves on retuning; or where something is missing, or what would decide. Everything else of the diagnosis has to be there.
std::string statement_of(const Diagnosis& diagnosis);

}  // namespace railpem::diagnosis

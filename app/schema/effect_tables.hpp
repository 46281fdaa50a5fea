#pragma once
// [[effect]] tables of a case file: effects of the library switched on by identifier, with their parameters by name.

#include <string>
#include <vector>

#include "app/refusals.hpp"
#include "app/schema/document.hpp"
#include "app/schema/schema.hpp"
#include "diagnosis/effects/effect.hpp"

namespace railpem::app {

/// Reads the [[effect]] tables of a case file whose schema is `root`. Throws InputError, unless there is `all`.
std::vector<diagnosis::EffectInstance> read_effects(const Document& document, const TableSchema& root,
                                                    Refusals* all = nullptr);

/// The case with the effects of its file. Throws InputError at the table of the effect that cannot be.
pem::CaseParameters with_effects(const Document& document, pem::CaseParameters parameters,
                                 const std::vector<diagnosis::EffectInstance>& effects);

/// The effects as [[effect]] tables: what each instance states, and nothing else.
std::string write_effects(const std::vector<diagnosis::EffectInstance>& effects);

/// The physical numbers of a case by dotted key, for a wrong number among the effects: all of case_numbers() but those
/// of the frequency lines and of the solver.
diagnosis::ParameterAccess parameter_access(const pem::CaseParameters& parameters);

}  // namespace railpem::app

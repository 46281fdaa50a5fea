#pragma once
// The case read from a file and written to one.

#include <string>
#include <vector>

#include "app/refusals.hpp"
#include "app/schema/document.hpp"
#include "diagnosis/effects/effect.hpp"
#include "pem/case_parameters.hpp"

namespace railpem::app {

/// A case with the document that it came from: whoever uses the case can say where something in it is wrong.
struct CaseFile {
    std::string name;  ///< of the file, without folder and extension: outputs are called after it
    pem::CaseParameters parameters;
    Document document;
    pem::CaseParameters without_effects;  ///< as the file states it, before its [[effect]] tables
    std::vector<diagnosis::EffectInstance> effects;
};

/// Reads a case, applies the options `--set key=value` in order, then the effects, and checks all of it, the rules of
/// physics included.
/// Throws InputError; with Refuse::all it holds every refusal of the first of these steps that refuses anything.
CaseFile read_case(const std::string& path, const std::vector<std::string>& options, Refuse refuse = Refuse::first);

/// The same for a text that is already there, called `name` in messages.
CaseFile parse_case(const std::string& name, const std::string& text, const std::vector<std::string>& options);

/// The same case with further options `--set key=value`. Throws InputError and leaves `file` as it is.
CaseFile changed_case(const CaseFile& file, const std::vector<std::string>& options);

/// The case as a TOML text that read_case() reads back to the same values. `effects` follow as [[effect]] tables;
/// `parameters` are those without them.
std::string write_case(const pem::CaseParameters& parameters,
                       const std::vector<diagnosis::EffectInstance>& effects = {});

}  // namespace railpem::app

#include "app/schema/case_file.hpp"

#include <filesystem>

#include "app/schema/apply_option.hpp"
#include "app/schema/case_schema.hpp"
#include "app/schema/effect_tables.hpp"
#include "app/schema/irregularity_files.hpp"
#include "app/schema/read_table.hpp"
#include "app/schema/write_table.hpp"
#include "parameters/parameter_error.hpp"

namespace railpem::app {

using namespace parameters;

namespace {

CaseFile read_document_as_case(Document document, const std::string& name, const std::vector<std::string>& options) {
    for (const std::string& option : options) apply_option(document, case_schema(), option);
    CaseFile file{.name = name, .document = std::move(document)};
    read_table(file.document, case_schema(), &file.without_effects);
    read_irregularity_files(file.document, file.without_effects.irregularity);
    file.effects = read_effects(file.document, case_schema());
    file.parameters = with_effects(file.document, file.without_effects, file.effects);
    try {
        pem::check(file.parameters);
    } catch (const ParameterError& error) {
        throw refused(file.document, error);
    }
    return file;
}

}  // namespace

CaseFile read_case(const std::string& path, const std::vector<std::string>& options) {
    return read_document_as_case(read_document(path), std::filesystem::path(path).stem().string(), options);
}

CaseFile parse_case(const std::string& name, const std::string& text, const std::vector<std::string>& options) {
    return read_document_as_case(parse_document(name, text), std::filesystem::path(name).stem().string(), options);
}

CaseFile changed_case(const CaseFile& file, const std::vector<std::string>& options) {
    return read_document_as_case(file.document, file.name, options);
}

std::string write_case(const pem::CaseParameters& parameters, const std::vector<diagnosis::EffectInstance>& effects) {
    const pem::CaseParameters defaults;
    return write_table(case_schema(), &parameters, &defaults) + write_effects(effects);
}

}  // namespace railpem::app

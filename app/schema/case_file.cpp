#include "app/schema/case_file.hpp"

#include <filesystem>
#include <functional>

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

/// One rule after the other, so that one which is broken does not hide the others; each says the same only once.
void check_every_rule(const Document& document, const pem::CaseParameters& parameters, Refusals* all) {
    const std::function<void()> rules[] = {
        [&] { vehicle::check(parameters.vehicle); }, [&] { track::check(parameters.track); },
        [&] { spectra::check(parameters.irregularity); }, [&] { pem::check(parameters); }};
    for (const std::function<void()>& rule : rules) {
        guarded(all, [&] {
            try {
                rule();
            } catch (const ParameterError& error) {
                throw refused(document, error);
            }
        });
        if (all && all->size() > 1 && std::string(all->back().what()) == (all->end() - 2)->what()) all->pop_back();
    }
}

CaseFile read_document_as_case(Document document, const std::string& name, const std::vector<std::string>& options,
                               Refuse refuse = Refuse::first) {
    Refusals found;
    Refusals* all = refuse == Refuse::all ? &found : nullptr;
    for (const std::string& option : options) guarded(all, [&] { apply_option(document, case_schema(), option); });
    CaseFile file{.name = name, .document = std::move(document), .without_effects = case_defaults()};
    read_table(file.document, case_schema(), &file.without_effects, all);
    file.effects = read_effects(file.document, case_schema(), all);
    throw_all(found);
    guarded(all, [&] { read_irregularity_files(file.document, file.without_effects.irregularity); });
    throw_all(found);
    guarded(all, [&] { file.parameters = with_effects(file.document, file.without_effects, file.effects); });
    throw_all(found);
    check_every_rule(file.document, file.parameters, all);
    throw_all(found);
    return file;
}

}  // namespace

CaseFile read_case(const std::string& path, const std::vector<std::string>& options, Refuse refuse) {
    return read_document_as_case(read_document(path), std::filesystem::path(path).stem().string(), options, refuse);
}

CaseFile parse_case(const std::string& name, const std::string& text, const std::vector<std::string>& options) {
    return read_document_as_case(parse_document(name, text), std::filesystem::path(name).stem().string(), options);
}

CaseFile changed_case(const CaseFile& file, const std::vector<std::string>& options) {
    return read_document_as_case(file.document, file.name, options);
}

std::string write_case(const pem::CaseParameters& parameters, const std::vector<diagnosis::EffectInstance>& effects) {
    const pem::CaseParameters defaults = case_defaults();
    return write_table(case_schema(), &parameters, &defaults) + write_effects(effects);
}

}  // namespace railpem::app

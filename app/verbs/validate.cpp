#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/schema/case_file.hpp"
#include "app/schema/read_table.hpp"
#include "app/schema/recording_schema.hpp"
#include "app/schema/sweep_schema.hpp"
#include "app/verbs/verbs.hpp"
#include "pem/rail/case_equilibrium.hpp"
#include "recordings/checks/check_tables.hpp"
#include "recordings/loading/load_recording.hpp"

namespace railpem::app {

namespace {

/// Every input file says what it is by its keys: only a sweep names a case, or what varies, only a recording has data.
bool is_sweep(const Document& document) {
    return document.root.find("case") || document.root.find("vary") || document.root.find("design");
}

int valid(const std::string& path, const std::string& kind, const std::string& title) {
    fmt::print("{}: a valid {}{}{}\n", path, kind, title.empty() ? "" : ": ", title);
    return 0;
}

/// A recording is right when its data are: all of them are read, a section at a time.
int validate_recording(const std::string& path) {
    const RecordingFile file = read_recording(path);
    constexpr std::size_t kSection = 600000;  // samples per channel held at once
    reading_data(file, [&] {
        recordings::load_in_sections(
            file.description, file.base, kSection, [&](const recordings::Recording& recording) {
                for (const recordings::Fault& fault : recordings::checks::check_tables(recording, {}))
                    fmt::print(stderr, "{}: warning: {}\n", path, fault.says);
            });
    });
    return valid(path, "recording", file.description.title);
}

int validate(const std::string& path) {
    std::error_code status;
    if (std::filesystem::is_directory(path, status)) return validate_recording(path);
    const Document document = read_document(path);
    if (is_recording(document)) return validate_recording(path);
    if (is_sweep(document)) return valid(path, "sweep", read_sweep(path, {}).description.title);
    const CaseFile file = read_case(path, {});
    try {
        pem::case_equilibrium(file.parameters);  // a pad that carries nothing shows there and not before
    } catch (const parameters::ParameterError& error) {
        throw refused(file.document, error);
    }
    return valid(path, "case", file.parameters.title);
}

}  // namespace

void add_validate(CLI::App& program, Run& run) {
    const auto path = std::make_shared<std::string>();
    CLI::App* verb = program.add_subcommand("validate", "say whether an input file is right, or where it is wrong");
    verb->footer(
        "Example:\n"
        "  railpem validate case.toml");
    verb->add_option("FILE", *path, "a case, a sweep, or a recording (its description or its folder)")->required();
    verb->callback([path, &run] { run = [path] { return validate(*path); }; });
}

}  // namespace railpem::app

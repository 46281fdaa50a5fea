#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/plausibility/implausible_case.hpp"
#include "app/schema/recording_schema.hpp"
#include "app/schema/sweep_schema.hpp"
#include "app/verbs/verbs.hpp"
#include "recordings/checks/check_tables.hpp"
#include "recordings/files/visible_text.hpp"
#include "recordings/loading/load_recording.hpp"

namespace railpem::app {

namespace {

/// Every input file says what it is by its keys: only a sweep names a case, or what varies, only a recording has data.
bool is_sweep(const Document& document) {
    return document.root.find("case") || document.root.find("vary") || document.root.find("design");
}

int valid(const std::string& path, const std::string& kind, const std::string& title) {
    fmt::print("{}: a valid {}{}{}\n", recordings::visible(path), kind, title.empty() ? "" : ": ", title);
    return 0;
}

/// A recording is right when its data are: all of them are read, a section at a time. What its data file says against
/// the description does not make it invalid, and is told.
int validate_recording(const std::string& path) {
    const RecordingFile file = read_recording(path, Refuse::all);
    std::vector<recordings::Fault> contradictions;
    constexpr std::size_t kSection = 600000;  // samples per channel held at once
    reading_data(file, [&] {
        recordings::load_in_sections(file.description, file.base, kSection, [&](const recordings::Recording& section) {
            if (section.series.start_s == 0.0) contradictions = section.contradictions;
            for (recordings::Fault& fault : recordings::checks::check_tables(section, {})) {
                fault.severity = recordings::Severity::warning;  // the file is valid: inspect says how bad it is
                contradictions.push_back(std::move(fault));
            }
        });
    });
    for (const recordings::Fault& fault : contradictions)
        std::fputs(
            recordings::visible_lines(fmt::format("{}: {}: {}\n", path, severity_name(fault.severity), fault.says))
                .c_str(),
            stderr);
    return valid(path, "recording", file.description.title);
}

int validate_case(const std::string& path, bool strict) {
    const CaseFile file = read_case(path, {}, Refuse::all);
    const CaseFigures figures = case_figures(file);  // a pad that carries nothing shows there and not before
    say_or_refuse(plausibility_warnings(file, figures), strict);
    for (const std::string& warning : figures.warnings) fmt::print(stderr, "warning: {}: {}\n", path, warning);
    valid(path, "case", file.parameters.title);
    fmt::print("{}", figures_text(figures));
    return 0;
}

/// The case that varies, and the values that it takes.
int validate_sweep(const std::string& path, bool strict) {
    const SweepFile file = read_sweep(path, {}, Refuse::all);
    say_or_refuse(sweep_warnings(path, file.plan), strict);
    return valid(path, "sweep", file.description.title);
}

int validate(const std::string& path, bool strict) {
    std::error_code status;
    if (std::filesystem::is_directory(path, status)) return validate_recording(path);
    const Document document = read_document(path);
    if (is_recording(document)) return validate_recording(path);
    return is_sweep(document) ? validate_sweep(path, strict) : validate_case(path, strict);
}

}  // namespace

void add_validate(CLI::App& program, Run& run) {
    const auto path = std::make_shared<std::string>();
    const auto strict = std::make_shared<bool>(false);
    CLI::App* verb = program.add_subcommand(
        "validate",
        "say whether an input file is right, or everything that is wrong with it; of a case also what "
        "follows from it: natural frequencies, loads, the band that is excited");
    verb->footer(
        "Example:\n"
        "  railpem validate case.toml");
    verb->add_option("FILE", *path, "a case, a sweep, or a recording (its description or its folder)")->required();
    verb->add_flag("--strict", *strict, "refuse values that are allowed and hardly believed, too");
    verb->callback([path, strict, &run] { run = [path, strict] { return validate(*path, *strict); }; });
}

}  // namespace railpem::app

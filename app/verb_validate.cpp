#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/case_schema.hpp"
#include "app/verbs.hpp"

namespace railpem::app {

namespace {

int validate(const std::string& path) {
    const CaseFile file = read_case(path, {});
    fmt::print("{}: a valid case{}{}\n", path, file.parameters.title.empty() ? "" : ": ", file.parameters.title);
    return 0;
}

}  // namespace

void add_validate(CLI::App& program, Run& run) {
    const auto path = std::make_shared<std::string>();
    CLI::App* verb = program.add_subcommand("validate", "say whether an input file is right, or where it is wrong");
    verb->add_option("FILE", *path, "the file")->required();
    verb->callback([path, &run] { run = [path] { return validate(*path); }; });
}

}  // namespace railpem::app

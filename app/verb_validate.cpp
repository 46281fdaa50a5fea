#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/case_schema.hpp"
#include "app/sweep_schema.hpp"
#include "app/verbs.hpp"

namespace railpem::app {

namespace {

/// Every input file says what it is by its keys: only a sweep names a case.
bool is_sweep(const Document& document) { return document.root.find("case") != nullptr; }

int validate(const std::string& path) {
    const bool sweep = is_sweep(read_document(path));
    const std::string title = sweep ? read_sweep(path, {}).description.title : read_case(path, {}).parameters.title;
    fmt::print("{}: a valid {}{}{}\n", path, sweep ? "sweep" : "case", title.empty() ? "" : ": ", title);
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

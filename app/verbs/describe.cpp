#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "app/input_error.hpp"
#include "app/schema/case_schema.hpp"
#include "app/schema/nearest_key.hpp"
#include "app/schema/recording_schema.hpp"
#include "app/schema/sweep_schema.hpp"
#include "app/verbs/verbs.hpp"
#include "effects/describe_effects.hpp"

namespace railpem::app {

namespace {

const std::map<std::string, std::string (*)()>& pages() {
    static const std::map<std::string, std::string (*)()> all = {{"case", describe_case},
                                                                 {"effects", effects::describe_effects},
                                                                 {"recording", describe_recording},
                                                                 {"sweep", describe_sweep}};
    return all;
}

int describe(const std::string& subject) {
    const auto page = pages().find(subject);
    if (page == pages().end()) {
        std::vector<std::string> names;
        for (const auto& [name, unused] : pages()) names.push_back(name);
        throw input_error("", "", {.option = "railpem describe"},
                          {.what = fmt::format("no page about '{}'", subject),
                           .allowed = joined(names),
                           .hint = did_you_mean(subject, names)});
    }
    std::fputs(page->second().c_str(), stdout);
    return 0;
}

}  // namespace

void add_describe(CLI::App& program, Run& run) {
    const auto subject = std::make_shared<std::string>();
    CLI::App* verb = program.add_subcommand("describe", "print the reference page of an input file");
    verb->footer(
        "Example:\n"
        "  railpem describe effects");
    verb->add_option("SUBJECT", *subject, "case, effects, recording or sweep")->required();
    verb->callback([subject, &run] { run = [subject] { return describe(*subject); }; });
}

}  // namespace railpem::app

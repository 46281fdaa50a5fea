#include "app/verbs/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "app/input_error.hpp"
#include "app/memory_shortage.hpp"
#include "app/program_version.hpp"
#include "app/provenance.hpp"
#include "app/schema/nearest_key.hpp"
#include "app/schema/schema.hpp"
#include "app/verbs/verbs.hpp"
#include "recordings/files/visible_text.hpp"

namespace railpem::app {

namespace {

constexpr int kDone = 0, kFailed = 1, kRefused = 2;

std::vector<std::string> verb_names(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(verb->get_name());
    return names;
}

/// The first argument must be a verb or an option of the program itself.
void check_verb(const CLI::App& program, int argc, const char* const* argv) {
    const std::vector<std::string> names = verb_names(program);
    if (argc < 2) throw InputError("railpem: no verb\nallowed: " + joined(names) + "; railpem --help says more");
    const std::string first = argv[1];
    if (first.starts_with("-") || std::find(names.begin(), names.end(), first) != names.end()) return;
    throw unknown_name("railpem", "verb", first, names);
}

/// Options of a verb, as the user types them.
std::vector<std::string> option_names(const CLI::App& verb) {
    std::vector<std::string> names;
    for (const CLI::Option* option : verb.get_options())
        if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
    return names;
}

InputError refused_arguments(const CLI::App& program, const CLI::ParseError& error) {
    const std::vector<CLI::App*> chosen = program.get_subcommands();
    const CLI::App& verb = chosen.empty() ? program : *chosen.front();
    const std::string name = chosen.empty() ? "railpem" : "railpem " + verb.get_name();
    const std::vector<std::string> extras = verb.remaining(true);
    // Of a value that is no good the message has the option and what it takes; all other options would bury that.
    if (dynamic_cast<const CLI::ValidationError*>(&error) || dynamic_cast<const CLI::ConversionError*>(&error))
        return InputError(fmt::format("{}: {}\nallowed: what {} --help says of it", name, error.what(), name));
    if (extras.empty())
        return InputError(fmt::format("{}: {}\nallowed: {}; {} --help says more", name, error.what(),
                                      joined(option_names(verb)), name));
    return input_error("", "", {.option = name},
                       {.what = fmt::format("unknown argument '{}'", extras.front()),
                        .allowed = fmt::format("{}; {} --help says more", joined(option_names(verb)), name),
                        .hint = did_you_mean(extras.front(), option_names(verb))});
}

int say(const std::string& message, int status) {
    // Names of files and words of theirs are among it.
    std::fputs((recordings::visible_lines(message) + "\n").c_str(), stderr);
    return status;
}

/// What was printed has to arrive: `railpem describe case > page` on a full disk is not done.
int printed(int status) {
    const bool lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
    return lost && status == kDone ? say("railpem: cannot write to the standard output", kFailed) : status;
}

int run_verb(int argc, const char* const* argv) {
    CLI::App program("Vehicle-track dynamics: random vibration of a car on a track, and what a simulation left out.",
                     "railpem");
    Run run;
    program.set_version_flag("--version", "railpem " + program_version_with_commit());
    program.footer(
        "railpem VERB --help says what a verb takes, with an example.\n"
        "Exit status: 0 done, 1 failed (memory, disk), 2 an input that was refused; the message says where and what is "
        "allowed.");
    program.require_subcommand(1);
    add_solve(program, run);
    add_static(program, run);
    add_receptance(program, run);
    add_compare(program, run);
    add_sweep(program, run);
    add_simulate(program, run);
    add_inspect(program, run);
    add_diagnose(program, run);
    add_validate(program, run);
    add_prove(program, run);
    add_describe(program, run);
    check_verb(program, argc, argv);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return program.exit(success);
    } catch (const CLI::ParseError& error) {
        throw refused_arguments(program, error);
    }
    return run();
}

}  // namespace

int run_program(int argc, const char* const* argv) {
    // A file or a reader that can take no more is reported, not a reason to vanish.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
    remember_command(argc, argv);
    Eigen::setNbThreads(1);  // our own team is the only one: a second beside it spins for the same cores
    try {
        return printed(run_verb(argc, argv));
    } catch (const InputError& error) {
        return say(error.what(), kRefused);
    } catch (const std::bad_alloc&) {
        say_memory_shortage();
        return kFailed;
    } catch (const std::exception& error) {
        return say(fmt::format("railpem: {}", error.what()), kFailed);
    }
}

}  // namespace railpem::app

#include "app/provenance.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/program_version.hpp"
#include "app/run_inputs.hpp"
#include "app/sha256.hpp"

namespace railpem::app {

namespace {

std::vector<std::string>& arguments() {
    static std::vector<std::string> all;
    return all;
}

/// Control characters would end a comment line, or forge one.
std::string on_one_line(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    return text;
}

/// Values of --set KEY=VALUE and --set=KEY=VALUE.
std::vector<std::string> set_options() {
    std::vector<std::string> set;
    const std::vector<std::string>& all = arguments();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i] == "--set" && i + 1 < all.size())
            set.push_back(all[i + 1]);
        else if (all[i].starts_with("--set="))
            set.push_back(all[i].substr(6));
    return set;
}

}  // namespace

void remember_command(int argc, const char* const* argv) {
    arguments().assign(argv, argv + std::max(argc, 0));
    if (!arguments().empty()) arguments().front() = "railpem";  // wherever it stands on this machine
}

Provenance program_provenance() {
    return {.program = "railpem " + program_version_with_commit(), .command = "", .set = {}, .inputs = {}};
}

Provenance run_provenance() {
    Provenance provenance = program_provenance();
    for (const std::string& argument : arguments())
        provenance.command += (provenance.command.empty() ? "" : " ") + shell_quoted(argument);
    provenance.set = set_options();
    for (const std::filesystem::path& path : noted_inputs())
        provenance.inputs.push_back({path.string(), sha256_of_file(path)});
    return provenance;
}

Provenance call_provenance(const std::vector<std::string>& paths, const std::vector<std::string>& set) {
    Provenance provenance = program_provenance();
    provenance.set = set;
    for (const std::string& path : paths)
        if (std::string hash = sha256_of_file(path); !hash.empty())
            provenance.inputs.push_back({path, std::move(hash)});
    return provenance;
}

std::string shell_quoted(const std::string& text) {
    constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
    if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string provenance_line(const Provenance& provenance) {
    std::string text = std::string(kProgramStamp) + provenance.program.substr(std::string("railpem").size());
    if (!provenance.command.empty()) text += "; command: " + provenance.command;
    for (const std::string& option : provenance.set) text += "; set: " + option;
    for (const InputFile& input : provenance.inputs)
        text += "; input: " + input.path + (input.sha256.empty() ? "" : " sha256 " + input.sha256);
    return on_one_line(text);
}

namespace {

std::string provenance_json(const Provenance& provenance) {
    nlohmann::ordered_json json = {{"says", std::string(kProgramStamp)},
                                   {"program", provenance.program},
                                   {"command", provenance.command},
                                   {"set", provenance.set},
                                   {"inputs", nlohmann::ordered_json::array()}};
    for (const InputFile& input : provenance.inputs)
        json["inputs"].push_back({{"path", input.path}, {"sha256", input.sha256}});
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Behind the last value of an object that is written with a line per key.
std::string with_last_key(std::string text, const std::string& json) {
    const std::size_t end = text.rfind('}');
    if (end == std::string::npos || text.front() != '{') return text;
    std::size_t last = text.find_last_not_of(" \n", end - 1);
    const bool first_key = text[last] == '{';
    return text.substr(0, last + 1) + (first_key ? "" : ",") + "\n  \"provenance\": " + json + "\n}\n";
}

/// A comment of HTML ends at its first "--".
std::string without_double_hyphens(std::string text) {
    for (std::size_t at = 0; (at = text.find("--", at)) != std::string::npos;) text.replace(at, 2, "-&#45;");
    return text;
}

}  // namespace

std::string stamped(const std::string& name, std::string text, const Provenance& provenance) {
    if (name.ends_with(".csv")) return text + "# " + provenance_line(provenance) + "\n";
    if (name.ends_with(".toml")) return "# " + provenance_line(provenance) + "\n" + text;
    if (name.ends_with(".json")) return with_last_key(std::move(text), provenance_json(provenance));
    if (!name.ends_with(".html")) return text;
    const std::size_t head = text.find('\n');  // behind the doctype, which has to stand first
    return text.insert(head == std::string::npos ? 0 : head + 1,
                       "<!-- " + without_double_hyphens(provenance_line(provenance)) + " -->\n");
}

}  // namespace railpem::app

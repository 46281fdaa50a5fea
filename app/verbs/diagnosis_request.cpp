#include "app/verbs/diagnosis_request.hpp"

#include <fmt/format.h>

#include "app/provenance.hpp"

namespace railpem::app {

std::string command_of(const DiagnosisRequest& request, const std::string& folder) {
    std::string text = "railpem diagnose " + shell_quoted(request.case_path);
    for (const std::string& path : request.recordings) text += " " + shell_quoted(path);
    for (const std::string& option : request.set) text += " --set " + shell_quoted(option);
    const DiagnosisRequest usual;
    if (request.window_s != usual.window_s) text += fmt::format(" --window {:g}", request.window_s);
    if (request.held_out != usual.held_out) text += fmt::format(" --held-out {:g}", request.held_out);
    if (request.most_effects != usual.most_effects) text += fmt::format(" --most-effects {}", request.most_effects);
    if (request.effort_s != usual.effort_s) text += fmt::format(" --effort {:g}", request.effort_s);
    for (const std::string& effect : request.without) text += " --without " + shell_quoted(effect);
    return text + " --out " + shell_quoted(folder);
}

}  // namespace railpem::app

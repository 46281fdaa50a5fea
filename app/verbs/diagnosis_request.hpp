#pragma once
// What a user asks of a diagnosis.

#include <string>
#include <vector>

namespace railpem::app {

/// What `railpem diagnose` is asked for, but where the results go.
struct DiagnosisRequest {
    std::string case_path;                ///< for the command that repeats it
    std::vector<std::string> recordings;  ///< folders or descriptions
    std::vector<std::string> without;     ///< effects that the catalogue shall not have
    std::vector<std::string> set;         ///< as given to --set, for the command; the case has them already
    std::vector<std::string> doubts;      ///< what is hardly believed of the case, for the report
    double window_s = 4.0, held_out = 0.25;
    double effort_s = 75.0;  ///< NamingOptions::effort_s
    int threads = 0, most_effects = 3;
};

/// The command that repeats a diagnosis, its results in `folder`.
std::string command_of(const DiagnosisRequest& request, const std::string& folder);

}  // namespace railpem::app

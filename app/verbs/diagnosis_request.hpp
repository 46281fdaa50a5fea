#pragma once
// A diagnosis as a user asks for it: its inputs read and checked, its run, its files.

#include <functional>
#include <string>
#include <vector>

#include "app/output_folder.hpp"
#include "app/schema/case_schema.hpp"
#include "diagnosis/findings/diagnosis.hpp"
#include "diagnosis/observations/observation_options.hpp"

namespace railpem::app {

/// What `railpem diagnose` is asked for, but where the results go.
struct DiagnosisRequest {
    std::string case_path;                ///< for the command that repeats it
    std::vector<std::string> recordings;  ///< folders or descriptions
    std::vector<std::string> without;     ///< effects that the catalogue shall not have
    std::vector<std::string> set;         ///< as given to --set, for the command; the case has them already
    double window_s = diagnosis::ObservationOptions{}.window_s,
           held_out = diagnosis::ObservationOptions{}.held_out_share;
    double effort_s = 75.0;  ///< NamingOptions::effort_s
    int threads = 0, most_effects = 3;
};

/// Who looks on while it runs.
struct DiagnosisObserver {
    std::function<void(double share)> progress;
    std::function<bool()> interrupted;  ///< true ends the search with what is known
};

/// Reads the recordings and diagnoses the case. `ready` is called when all inputs are found right, before the long
/// part. Throws InputError.
diagnosis::Diagnosis run_diagnosis(const CaseFile& file, const DiagnosisRequest& request,
                                   const DiagnosisObserver& observer, const std::function<void()>& ready);

/// Puts diagnosis.json, the tables, the report and the diagnosed case into the folder. Not committed.
void write_diagnosis(OutputFolder& folder, const diagnosis::Diagnosis& result, const DiagnosisRequest& request);

/// The command that repeats a diagnosis, its results in `folder`.
std::string command_of(const DiagnosisRequest& request, const std::string& folder);

}  // namespace railpem::app

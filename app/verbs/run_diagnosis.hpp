#pragma once
// A diagnosis as a user asks for it: its inputs read and checked, its run, its files.

#include <functional>

#include "app/output_folder.hpp"
#include "app/schema/case_file.hpp"
#include "app/verbs/diagnosis_request.hpp"
#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app {

/// Who looks on while it runs.
struct DiagnosisObserver {
    std::function<void(double share)> progress;
    std::function<bool()> interrupted;  ///< true ends the search with what is known
};

/// Reads the recordings and diagnoses the case. `ready` is called when all inputs are found right, before the long
/// part. Throws InputError.
diagnosis::Diagnosis run_diagnosis(const CaseFile& file, const DiagnosisRequest& request,
                                   const DiagnosisObserver& observer, const std::function<void()>& ready);

/// Files that every diagnosis writes, whatever it says.
inline constexpr const char* kDiagnosisFiles[] = {"diagnosis.json", "report.html", "diagnosed.toml"};

/// Puts diagnosis.json, the tables, the report and the diagnosed case into the folder. Not committed.
void write_diagnosis(OutputFolder& folder, const diagnosis::Diagnosis& result, const DiagnosisRequest& request);

}  // namespace railpem::app

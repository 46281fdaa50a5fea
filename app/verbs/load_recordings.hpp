#pragma once
// The recordings of a diagnosis: read, inspected, observed.

#include <string>
#include <vector>

#include "app/schema/case_file.hpp"
#include "app/verbs/diagnosis_request.hpp"
#include "diagnosis/observations/believed_case.hpp"
#include "diagnosis/observations/observation.hpp"
#include "recordings/measured_irregularity.hpp"

namespace railpem::app {

/// What a diagnosis needs of recordings, and what is said of each.
struct LoadedRecordings {
    std::vector<diagnosis::Observation> observations;
    std::vector<std::vector<std::string>> faults;             ///< per observation
    std::vector<std::vector<std::string>> channels_not_used;  ///< per observation
    std::vector<bool> irregularity_measured;                  ///< per observation
    std::vector<recordings::MeasuredIrregularity> irregularity;

    void add(const diagnosis::Observation& observation, std::vector<std::string> own_faults,
             std::vector<std::string> not_used) {
        observations.push_back(observation);
        faults.push_back(std::move(own_faults));
        channels_not_used.push_back(std::move(not_used));
    }

    void append(LoadedRecordings other) {
        const auto move_to = [](auto& from, auto& to) {
            to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
        };
        move_to(other.observations, observations);
        move_to(other.faults, faults);
        move_to(other.channels_not_used, channels_not_used);
        move_to(other.irregularity_measured, irregularity_measured);
        move_to(other.irregularity, irregularity);
    }
};

/// Read one after the other, for not every library that reads is safe between threads; looked at side by side. Throws
/// InputError.
LoadedRecordings load_recordings(const DiagnosisRequest& request, const CaseFile& file,
                                 const diagnosis::BelievedCase& believed);

}  // namespace railpem::app

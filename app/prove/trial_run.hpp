#pragma once
// One trial: the true world is marched in time, and the diagnosis meets its recordings.

#include <filesystem>
#include <functional>

#include "app/prove/trial_result.hpp"
#include "app/prove/trial_truth.hpp"
#include "diagnosis/diagnose.hpp"
#include "recordings/recording.hpp"
#include "simulate/recording.hpp"

namespace railpem::app {

/// How every trial is diagnosed. Fixed before anything is drawn.
struct TrialOptions {
    diagnosis::DiagnoseOptions diagnosis;
    diagnosis::ObservationOptions observation;
};

/// The records of a trial as the sensors gave them, speeds as stated. They are marched side by side on up to `threads`
/// threads.
std::vector<simulate::Recording> simulate_trial(const TrialTruth& truth, int threads);

/// A simulated recording as if its files had been read: same description, samples in full precision.
recordings::Recording measured_recording(const simulate::Recording& simulated);

/// What the diagnosis says about recordings. It is given the believed case and the recordings, and knows nothing of the
/// truth.
diagnosis::Diagnosis diagnose_recordings(const diagnosis::BelievedCase& believed,
                                         const std::vector<recordings::Recording>& recordings,
                                         const TrialOptions& options);

/// Simulates and diagnoses. With `keep` the recordings are written below it, as record_1, record_2, …, for `railpem
/// diagnose`. What stops the trial is put into TrialResult::failure; only what concerns the output is thrown.
TrialResult run_trial(const diagnosis::BelievedCase& believed, const TrialTruth& truth, const TrialOptions& options,
                      const std::filesystem::path& keep);

}  // namespace railpem::app

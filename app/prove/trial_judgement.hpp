#pragma once
// One trial held against its truth.

#include <limits>
#include <string>
#include <vector>

#include "app/prove/proportion.hpp"
#include "app/prove/trial_result.hpp"
#include "app/prove/trial_truth.hpp"

namespace railpem::app {

/// By eye nothing is wrong: the third-octave misfit after retuning, dB.
inline constexpr double kConcealed_db = 0.3;

/// What a verdict amounts to. one_set: named with confidence (`explained`, `recording-fault`); several_sets:
/// `ambiguous`; no_name: something is missing that has no name (`unexplained`).
enum class Claim { failed, nothing, one_set, several_sets, no_name };

struct Judgement {
    bool missing = false;    ///< something is hidden
    bool concealed = false;  ///< something is hidden, and retuning brings the misfit below kConcealed_db
    Claim claim = Claim::failed;
    bool right_place = false;  ///< the first place is one in which something is hidden
    /// the one set named is what is hidden: same effects, channels, wheels, stages, numbers
    bool right_effect = false;
    bool truth_returned = false;      ///< what is hidden is among the sets returned
    std::size_t sets_returned = 0;    ///< 1 for `consistent`, 0 for `unexplained`
    std::size_t right_names = 0;      ///< effects named with confidence that are hidden
    std::size_t wrong_names = 0;      ///< and that are not
    bool sensor_for_physics = false;  ///< a sensor is named and only physics is hidden
    bool physics_for_sensor = false;  ///< physics is named and only sensors are at fault
    Proportion parameters;            ///< named parameters whose interval holds the truth, where the effect is right
    /// believed numbers whose interval holds the truth, where the effect is right or nothing is hidden
    Proportion numbers;
    /// held-out nats per second; only where the effect is right
    double misfit_retuned = std::numeric_limits<double>::quiet_NaN();
    double misfit_after = std::numeric_limits<double>::quiet_NaN();
    std::string baseline_retuning;  ///< what somebody who only retunes would say: consistent, a wrong number, misfit
    std::string baseline_bic;       ///< BIC over the PSDs: consistent, or the best set
    std::string hidden;             ///< row of the confusion matrix: nothing, an effect, "pair"
    std::string returned;           ///< column: nothing, an effect, several, ambiguous, unexplained, failed
    std::string wrong;              ///< what is wrong with the verdict; empty: nothing
};

Judgement judge(const TrialTruth& truth, const TrialResult& result);

/// Identifiers with what tells their instances apart: "… (bogie_1)".
std::string label_of(const ClaimedEffect& claimed);
std::string label_of(const simulate::Hidden& hidden);

}  // namespace railpem::app

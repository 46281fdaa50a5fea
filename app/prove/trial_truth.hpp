#pragma once
// What a trial of the proof hides, as data.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/schema/world_option.hpp"
#include "diagnosis/observations/believed_case.hpp"
#include "pem/case_parameters.hpp"
#include "simulate/effects/hidden_effects.hpp"

namespace railpem::app {

/// nothing: a null. outside: an effect that the catalogue does not have.
enum class TrialKind { nothing, single, pair, sensor, parameter_error, outside };

/// "nothing", "single", …
std::string kind_name(TrialKind kind);

/// One record of a trial.
struct TrialRecord {
    double speed_m_per_s = 0.0;
    double stated_speed_m_per_s = 0.0;  ///< as the recording says it
    double payload_kg = 0.0;            ///< known to the diagnosis
    std::uint64_t seed = 0;             ///< draws track and noise
};

/// A number of the case as it is believed and as it is, all errors of the trial included.
struct TrueNumber {
    std::string key;
    double believed = 0.0;
    double truth = 0.0;
};

struct TrialTruth {
    std::size_t trial = 0;  ///< from 0
    TrialKind kind = TrialKind::nothing;
    std::vector<simulate::Hidden> hidden;
    std::vector<TrueNumber> numbers;  ///< those that have a tolerance
    double level_db = 0.0;            ///< nuisance error of the believed irregularity
    double noise_rms_m_per_s2 = 0.0;  ///< of every channel
    double seconds = 60.0;            ///< of every record
    std::vector<TrialRecord> records;
    pem::CaseParameters parameters;  ///< of the true world, what is hidden included
    simulate::OnlyHereParameters only_here;
    World world;  ///< in which its records are made
};

/// Elements of the structure in which something is hidden, as the diagnosis writes them; each once.
std::vector<std::string> true_places(const TrialTruth& truth);

/// Value of the parameter by which the hidden effect fades; NaN for none, several, or an effect without such a
/// parameter.
double true_strength(const TrialTruth& truth);

/// The true value of a fitted parameter of `effect` in what is hidden, nuisance errors of the believed case included;
/// NaN where the truth has no such number. `key`: of the number, where that is what is wrong.
double true_value(const TrialTruth& truth, const std::string& effect, const std::string& key,
                  const std::string& parameter);

/// Grade and all numbers of a world.
nlohmann::ordered_json world_json(const World& world);

/// The truth as JSON. Equal trials give equal bits.
std::string trial_truth_text(const TrialTruth& truth);

}  // namespace railpem::app

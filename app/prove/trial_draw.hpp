#pragma once
// What a trial hides is drawn from the seed of the proof and the number of the trial, and from nothing else.

#include <array>
#include <cstdint>

#include "app/prove/trial_truth.hpp"
#include "app/schema/case_file.hpp"

namespace railpem::app {

/// Shares of the kinds of trials, in the order of TrialKind; they sum to 1. Singles outnumber the rest because every
/// effect of the catalogue needs its own.
struct TrialMix {
    std::array<double, 6> shares{0.18, 0.38, 0.12, 0.12, 0.08, 0.12};
};

/// How trials are drawn.
struct DrawSettings {
    std::uint64_t seed = 0;
    TrialMix mix;
    double seconds = 60.0;  ///< of every record
    int most_records = 3;   ///< speeds of a trial: 1 to this many
    double least_speed_m_per_s = 12.0, most_speed_m_per_s = 40.0;
    double speed_ratio = 1.15;    ///< two speeds of a trial are at least so far apart
    double speed_error = 0.005;   ///< of a stated speed: the tolerance that a diagnosis gives it
    double payload_share = 0.25;  ///< of trials with several records in which one of them is loaded
    double least_payload_kg = 4000.0, most_payload_kg = 12000.0;
    double level_db = 1.0;             ///< error of the believed irregularity, either way
    double noise_rms_m_per_s2 = 0.02;  ///< white, of the ideal world; another one has noise of its own
    World world;
};

/// The trial of that number. Kinds follow a low-discrepancy sequence, and effects of a kind take turns in an order
/// drawn by the seed, so that any first N trials hold the mix: a proof can be lengthened. Every number with a tolerance
/// is off by up to that, uniformly. Effects that the case forbids are not drawn.
TrialTruth draw_trial(const CaseFile& file, const diagnosis::BelievedCase& believed, const DrawSettings& settings,
                      std::size_t trial);

/// Identifiers of the effects that this case lets a kind of trial draw, in the order of the catalogue.
std::vector<std::string> drawable_effects(const CaseFile& file, TrialKind kind);

}  // namespace railpem::app

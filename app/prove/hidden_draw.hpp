#pragma once

#include <string>
#include <vector>

#include "app/prove/draw_stream.hpp"
#include "app/prove/effect_draws.hpp"
#include "app/prove/trial_truth.hpp"
#include "app/schema/case_file.hpp"

namespace railpem::app {

/// An effect with values from its draw (effect_draws.hpp). Lines of wheels and corrugation are drawn until they lie
/// between 4 and 150 Hz at one of the speeds at least: nobody could see another.
simulate::Hidden draw_effect(const std::string& id, const CaseFile& file, const diagnosis::BelievedCase& believed,
                             const std::vector<TrialRecord>& records, DrawStream& stream);

}  // namespace railpem::app

#pragma once

#include <string>

#include "app/page/page_parts.hpp"
#include "app/prove/trial_draw.hpp"
#include "app/schema/believed_case.hpp"
#include "app/schema/case_file.hpp"
#include "app/schema/recording_schema.hpp"

namespace railpem::app {

/// The case that a proof believes, and what the diagnosis makes of it.
struct ProofCase {
    CaseFile file = parse_case("case1", std::string(proved_case()), {});
    diagnosis::BelievedCase believed = believed_case(file);

    TrialTruth draw(std::uint64_t seed, std::size_t trial) const {
        return draw_trial(file, believed, {.seed = seed}, trial);
    }
};

}  // namespace railpem::app

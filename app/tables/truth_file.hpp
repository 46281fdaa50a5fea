#pragma once

#include <string>
#include <vector>

#include "pem/case_parameters.hpp"
#include "simulate/effects/hidden_effects.hpp"
#include "simulate/march/options.hpp"
#include "simulate/recording.hpp"

namespace railpem::app {

/// What a simulated recording was made of.
struct Truth {
    std::string case_path;
    std::vector<std::string> set_options;  ///< as given to --set
    std::vector<simulate::Hidden> hidden;
    std::string world = "ideal";     ///< name of its grade
    pem::CaseParameters parameters;  ///< of the case, with what is hidden in it
    simulate::Options options;
};

/// The truth as JSON: case, seed, every hidden effect with all its parameters, the grade of the world with all its
/// parameters and what was drawn, how the recording was made, and the true
/// case as a case file (without the effects that exist only in the simulator). The same run gives the same bits.
std::string truth_text(const Truth& truth, const simulate::Recording& recording);

}  // namespace railpem::app

#pragma once
// A simulation as a user asks for it: its options checked, its recording and the truth about it.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/schema/case_file.hpp"
#include "app/tables/truth_file.hpp"

namespace railpem::app {

/// What `railpem simulate` is asked for, but where the results go.
struct SimulationRequest {
    std::string path;               ///< of the case, for the truth
    std::vector<std::string> set;   ///< as given to --set, for the truth; the case has them already
    std::vector<std::string> hide;  ///< as given to --hide
    std::string profile;            ///< file of a measured profile; empty: drawn
    std::string world;              ///< as given to --world; empty: ideal
    std::string speed_profile;      ///< file of speeds against time; empty: constant
    double seconds = 0.0;
    std::int64_t seed = 0;
    std::optional<double> speed;
    std::optional<std::int64_t> profile_seed;
    double rate_hz = 1000.0, noise = 0.0, speed_fluctuation = 0.0, profile_length_m = 0.0;
    bool force = false, standing = false, speed_channel = false;
};

/// Throws InputError: `option` is as given, `what` is wrong with it, `allowed` is what would not be.
[[noreturn]] void refuse_option(const std::string& option, const std::string& what, const std::string& allowed);

/// Ranges of the options. Throws InputError that names the option.
void check_simulation(const SimulationRequest& request);

/// What will be simulated: the case with what is hidden in it, and the options of the march. Throws InputError.
Truth planned_simulation(const CaseFile& file, const SimulationRequest& request);

/// Marches. `progress` is called about a hundred times; what it throws ends the march. Throws InputError.
simulate::Recording run_simulation(const CaseFile& file, const Truth& truth,
                                   const std::function<void(double done_s, double total_s)>& progress);

}  // namespace railpem::app

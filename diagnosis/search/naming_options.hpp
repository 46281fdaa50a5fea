#pragma once

#include <functional>
#include <string>
#include <vector>

namespace railpem::diagnosis {

/// Thresholds of the search. Set by judgement on a few dozen marched and drawn recordings; calibrate_verdict measures
/// their false alarms.
struct NamingOptions {
    int most_effects = 3;
    /// effects that the catalogue shall not have: what would be said if nobody knew of them
    std::vector<std::string> without;
    int refits = 7;              ///< candidates refitted in the first round
    int later_refits = 3;        ///< and in each further one
    double least_promise = 7.0;  ///< nats to first order that deserve a refit
    /// nats that free corrections may promise by chance; more, and the search starts again from afar
    double residual = 12.0;
    double least_gain = 5.0;  ///< nats of log-evidence with prior that a further member must bring
    /// Effort after which nothing further is looked for, of three minutes of recordings with nine channels:
    /// effort_allowed()
    double effort_s = 75.0;
    std::function<void(const std::string&, double)> progress;  ///< what is being done, share done
    std::function<bool()> interrupted;  ///< asked between steps; true ends the search with what is known
};

}  // namespace railpem::diagnosis

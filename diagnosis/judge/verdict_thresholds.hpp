#pragma once

namespace railpem::diagnosis {

/// How sure a verdict has to be. Of 300 synthesised nulls nothing gained and no free correction promised more than −3.8
/// nats (docs/proof/README.md, calibrate_verdict).
struct VerdictThresholds {
    double least_gain = 5.0;  ///< nats of log-evidence that physics must gain over the retuned case
    /// the same where nothing is added, and numbers, the irregularity or the passing of sleepers are further off than
    /// was believed: as much has a number 3.7 tolerances off, which of fourteen by chance one is in 300 cases
    double belief_gain = 1.5;
    double credible = 4.0;  ///< a rival set is credible within so many nats of the best
    /// nats that a free correction beside the named set may promise by chance, or nats_left() of it (model_error.hpp)
    double residual = 12.0;
    double anonymous = 3.0;  ///< nats by which a free correction must beat the named set to make it nameless
    /// by which a number may end beside a name, furthest_number(), unless its law bends numbers
    /// (Effect::bends_numbers): between the most beside a right one (3.9) and the least beside a wrong one (5.3, a play
    /// of the fastenings)
    double number_tolerances = 4.5;
    /// by which levels may be off, beyond chance and stated errors, in a case that explains, alone or with a name
    /// without friction: repeated_level_db(), scalar_level_db(). Stated: what a verdict promises
    double level_db = 1.0;
};

}  // namespace railpem::diagnosis
